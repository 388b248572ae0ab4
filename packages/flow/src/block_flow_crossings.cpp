#include <algorithm>
#include <set>

#include "block_flow_builder.hpp"
#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/base/ascending.hpp"
#include "values_reader.hpp"

namespace ndframe
{
namespace
{

void append(Vector& values, const Direction& direction)
{
  values.insert(values.end(), direction.begin(), direction.end());
}

} // namespace

void BlockFlow::Builder::joinBetween()
{
  std::map<std::array<int, 2>, std::vector<Spring>> own, joined;
  const auto setOf = [this](int half) { return flow_.setOf_[std::size_t(half / 4)]; };
  for (const OwnFace& face : faces_)
    if (!staysInside(face)) {
      const auto [low, high] = std::minmax({setOf(face.half[0]), setOf(face.half[1])});
      own[{low, high}].push_back(Spring::ofFace(face.centre, face.conductance, face.size));
    }
  Vector records;
  for (const auto& [sets, springs] : own) {
    const Spring whole = Spring::joined(springs);
    records.insert(records.end(), {double(sets[0]), double(sets[1]), whole.conductance});
    append(records, whole.centre);
    records.insert(records.end(), whole.turning.begin(), whole.turning.end());
  }
  const Vector all = gatheredFrom(records, comm_);
  for (ValuesReader reader(all); reader;) {
    const int low = int(reader.number()), high = int(reader.number());
    Spring spring;
    spring.conductance = reader.value();
    spring.centre = reader.direction();
    for (double& value : spring.turning)
      value = reader.value();
    joined[{low, high}].push_back(spring);
  }
  std::vector<WrenchFlow::Link> links;
  for (const auto& [sets, springs] : joined) {
    linkOf_.emplace(sets, int(links.size()));
    links.push_back({sets, Spring::joined(springs)});
  }
  flow_.between_ = std::make_unique<WrenchFlow>(std::move(setCentres_), std::move(links));
}

/// Ranks get the faces around their boxes.
std::vector<Vector> BlockFlow::Builder::sentCrossings() const
{
  std::vector<Vector> out(std::size_t(comm_.size()));
  for (const OwnFace& face : faces_) {
    if (staysInside(face))
      continue;
    Vector record;
    for (const int half : face.half)
      record.insert(record.end(), {double(number(half / 4)), double(flow_.setOf_[std::size_t(half / 4)])});
    record.insert(record.end(), {face.conductance, face.size});
    append(record, face.centre);
    std::set<int> ranks;
    for (const int half : face.half)
      ranks.insert(ranksOf_[std::size_t(block(half))].begin(), ranksOf_[std::size_t(block(half))].end());
    for (const int rank : ranks)
      out[std::size_t(rank)].insert(out[std::size_t(rank)].end(), record.begin(), record.end());
  }
  return exchangedValues(out, comm_);
}

void BlockFlow::Builder::takeCrossings()
{
  std::vector<NumberPair> pairs;
  for (const Vector& values : sentCrossings())
    for (ValuesReader reader(values); reader;) {
      NumberPair cells{};
      std::array<int, 2> sets{};
      for (std::size_t side = 0; side < 2; ++side) {
        cells[side] = reader.number();
        sets[side] = int(reader.number());
      }
      const auto [low, high] = std::minmax({sets[0], sets[1]});
      const double conductance = reader.value(), size = reader.value();
      pairs.push_back(cells);
      flow_.crossings_.push_back({linkOf_.at({low, high}),
                                  sets[0] == low ? 1.0 : -1.0,
                                  {placeOf(near_, cells[0]), placeOf(near_, cells[1])},
                                  Spring::ofFace(reader.direction(), conductance, size)});
    }
  crossing_ = inOrder(pairs, flow_.crossings_);
}

/// Own half facets learn where their flow is: both sides of a face at once, where they are own.
void BlockFlow::Builder::findPlaces()
{
  std::vector<int> found(flow_.halves_, -1);
  std::array<std::size_t, 2> next{}; // of the pairs inside and of the crossings: most follow one another
  const auto find = [&](const NumberPair& cells, bool isCrossing) {
    const std::vector<NumberPair>& pairs = isCrossing ? crossing_ : inner_;
    std::size_t& place = next[std::size_t(isCrossing)];
    if (place >= pairs.size() || pairs[place] != cells)
      place = std::size_t(placeOf(pairs, cells));
    return int(place++);
  };
  flow_.places_.reserve(2 * faces_.size());
  const auto add = [&](int half, int number, bool isCrossing, double sign) {
    flow_.places_.push_back({half, number, isCrossing, sign});
    found[std::size_t(half)] = number;
  };
  for (const OwnFace& face : faces_) {
    const bool isCrossing = !staysInside(face);
    const auto [half, twin] = face.half;
    const int place = find({number(half / 4), number(twin / 4)}, isCrossing);
    add(half, place, isCrossing, 1.0);
    if (isOwn(twin / 4))
      add(twin, place, isCrossing, -1.0);
  }
  for (const int cell : flow_.own_)
    for (int half = cell * 4; half < cell * 4 + 4; ++half)
      if (const int twin = twins_[std::size_t(half)]; twin >= 0 && found[std::size_t(half)] < 0) {
        const bool isCrossing = block(half) != block(twin);
        add(half, find({number(twin / 4), number(cell)}, isCrossing), isCrossing, -1.0);
      }
}

} // namespace ndframe
