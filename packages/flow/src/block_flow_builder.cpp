#include "block_flow_builder.hpp"

#include <algorithm>
#include <cmath>

#include "block_grid.hpp"
#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/base/ascending.hpp"
#include "ndframe/equilibrium/facet_twins.hpp"
#include "values_reader.hpp"

namespace ndframe
{
namespace
{

using Number = BlockFlow::Builder::Number;

constexpr int cellsOfBlock = 500, mostBlocks = 20000;

} // namespace

void BlockFlow::Builder::fetch(std::vector<int>& ofHeld) const
{
  if (piece_ == nullptr)
    return;
  Vector values(ofHeld.begin(), ofHeld.end());
  piece_->shared.fetch([](int cell) { return SharedValues::Place{std::size_t(cell), 1}; }, values);
  std::transform(values.begin(), values.end(), ofHeld.begin(), [](double value) { return int(value); });
}

/// To all ranks with cells in a box.
void BlockFlow::Builder::send(std::vector<Vector>& out, int block, std::initializer_list<double> record) const
{
  for (const int rank : ranksOf_[std::size_t(block)])
    out[std::size_t(rank)].insert(out[std::size_t(rank)].end(), record);
}

void BlockFlow::Builder::findOwn()
{
  for (int cell = 0; cell < mesh_.numCells(); ++cell) {
    flow_.centres_.push_back(cellCentre(mesh_, cell));
    if (isOwn(cell))
      flow_.own_.push_back(cell);
  }
  flow_.halves_ = std::size_t(mesh_.numCells()) * 4;
}

void BlockFlow::Builder::findBlocks()
{
  std::vector<Direction> centres;
  for (const int cell : flow_.own_)
    centres.push_back(flow_.centre(cell));
  const BlockGrid grid(centres, cellsOfBlock, mostBlocks, comm_);
  blockOf_.assign(std::size_t(mesh_.numCells()), -1);
  std::vector<char> isNear(std::size_t(grid.size()), 0);
  for (const int cell : flow_.own_) {
    blockOf_[std::size_t(cell)] = grid.blockOf(flow_.centre(cell));
    isNear[std::size_t(blockOf_[std::size_t(cell)])] = 1;
  }
  fetch(blockOf_);
  Vector blocks;
  for (int block = 0; block < grid.size(); ++block)
    if (isNear[std::size_t(block)] != 0)
      blocks.insert(blocks.end(), {double(block), double(comm_.rank())});
  ranksOf_.resize(std::size_t(grid.size()));
  const Vector all = gatheredFrom(blocks, comm_);
  for (std::size_t at = 0; at < all.size(); at += 2)
    ranksOf_[std::size_t(all[at])].push_back(int(all[at + 1]));
}

/// Of a cell in the order of the cells behind them, so that where cells' numbers ascend pairs of cells do.
void BlockFlow::Builder::findFaces()
{
  const std::vector<SortedCell> cells = sortedCells(mesh_);
  twins_ = facetTwins(cells, 3);
  Vector volumes;
  for (int cell = 0; cell < mesh_.numCells(); ++cell)
    volumes.push_back(cellMeasure(mesh_, cell));
  faces_.reserve(2 * flow_.own_.size());
  std::vector<int> halves;
  for (const int cell : flow_.own_) {
    halves.clear();
    for (int half = cell * 4; half < cell * 4 + 4; ++half)
      if (const int twin = twins_[std::size_t(half)]; twin >= 0 && number(twin / 4) >= number(cell))
        halves.push_back(half);
    const auto behind = [this](int half) { return number(twins_[std::size_t(half)] / 4); };
    std::sort(halves.begin(), halves.end(), [&](int a, int b) { return behind(a) < behind(b); });
    for (const int half : halves) {
      const int twin = twins_[std::size_t(half)];
      const Facet facet{cell, cells[std::size_t(cell)].local[std::size_t(half % 4)]};
      double normal[3];
      const double area = facetNormal(mesh_, facet, normal), size = std::sqrt(area);
      const double conductance = area * area / (volumes[std::size_t(cell)] + volumes[std::size_t(twin / 4)]);
      faces_.push_back({{half, twin}, facetCentre(mesh_, facet), conductance, size});
    }
  }
}

/// All ranks with cells in a box get all its cells.
void BlockFlow::Builder::takeNear()
{
  std::vector<Vector> out(std::size_t(comm_.size()));
  for (const int cell : flow_.own_)
    send(out, blockOf_[std::size_t(cell)], {double(number(cell))});
  const std::vector<Vector> in = exchangedValues(out, comm_);
  for (const Vector& numbers : in)
    near_.insert(near_.end(), numbers.begin(), numbers.end());
  std::sort(near_.begin(), near_.end());
  std::vector<SharedWith> neighbours;
  for (int rank = 0; rank < comm_.size(); ++rank) {
    SharedWith other{rank, {}, {}};
    const auto places = [&](const Vector& numbers) {
      std::vector<int> result;
      for (const double value : numbers)
        result.push_back(placeOf(near_, Number(value)));
      return result;
    };
    if (rank != comm_.rank() && !in[std::size_t(rank)].empty())
      neighbours.push_back({rank, places(out[std::size_t(rank)]), places(in[std::size_t(rank)])});
  }
  flow_.shared_ = SharedValues(std::move(neighbours), comm_);
  for (const int cell : flow_.own_)
    flow_.nearOf_.push_back(placeOf(near_, number(cell)));
}

void BlockFlow::Builder::joinWithin()
{
  constexpr std::size_t perCell = 3;
  Vector places(near_.size() * perCell, 0.0);
  for (std::size_t i = 0; i < flow_.own_.size(); ++i)
    std::copy_n(flow_.centre(flow_.own_[i]).begin(), perCell,
                places.begin() + std::ptrdiff_t(perCell) * flow_.nearOf_[i]);
  flow_.shared_.fetch([](int cell) { return SharedValues::Place{std::size_t(cell) * perCell, perCell}; }, places);
  std::vector<Vector> out(std::size_t(comm_.size()));
  for (const OwnFace& face : faces_)
    if (staysInside(face))
      send(out, block(face.half[0]),
           {double(number(face.half[0] / 4)), double(number(face.half[1] / 4)), face.conductance, face.size,
            face.centre[0], face.centre[1], face.centre[2]});
  std::vector<WrenchFlow::Link> links;
  std::vector<NumberPair> cells;
  for (const Vector& values : exchangedValues(out, comm_))
    for (ValuesReader reader(values); reader;) {
      const Number first = reader.number(), second = reader.number();
      const double conductance = reader.value(), size = reader.value();
      cells.push_back({first, second});
      links.push_back(
          {{placeOf(near_, first), placeOf(near_, second)}, Spring::ofFace(reader.direction(), conductance, size)});
    }
  inner_ = inOrder(cells, links);
  std::vector<Direction> centres;
  for (std::size_t at = 0; at < places.size(); at += perCell)
    centres.push_back({places[at], places[at + 1], places[at + 2]});
  flow_.within_ = std::make_unique<WrenchFlow>(std::move(centres), std::move(links));
}

/// Sets of cells that hang together in a box are numbered by their lowest cells, whose owners say where they are.
void BlockFlow::Builder::numberSets()
{
  const WrenchFlow& within = *flow_.within_;
  std::vector<char> isOwnNear(near_.size(), 0);
  for (const int near : flow_.nearOf_)
    isOwnNear[std::size_t(near)] = 1;
  std::vector<Direction> centres(std::size_t(within.numParts()), Direction{});
  Vector counts(centres.size(), 0.0), own;
  for (int near = 0; near < within.size(); ++near) {
    const auto part = std::size_t(within.partOf(near));
    counts[part] += 1.0;
    for (std::size_t i = 0; i < 3; ++i)
      centres[part][i] += within.centre(near)[i];
  }
  for (int part = 0; part < within.numParts(); ++part)
    if (const int first = within.firstOf(part); isOwnNear[std::size_t(first)] != 0) {
      own.push_back(double(near_[std::size_t(first)]));
      for (const double sum : centres[std::size_t(part)])
        own.push_back(sum / counts[std::size_t(part)]);
    }
  std::map<Number, Direction> sets;
  const Vector all = gatheredFrom(own, comm_);
  for (ValuesReader reader(all); reader;) {
    const Number lowest = reader.number();
    sets.emplace(lowest, reader.direction());
  }
  std::vector<Number> lowest;
  for (const auto& [number, centre] : sets) {
    lowest.push_back(number);
    setCentres_.push_back(centre);
  }
  for (int part = 0; part < within.numParts(); ++part)
    setOfPart_.push_back(placeOf(lowest, near_[std::size_t(within.firstOf(part))]));
  flow_.setOf_.assign(std::size_t(mesh_.numCells()), -1);
  for (std::size_t i = 0; i < flow_.own_.size(); ++i)
    flow_.setOf_[std::size_t(flow_.own_[i])] = setOfPart_[std::size_t(within.partOf(flow_.nearOf_[i]))];
  fetch(flow_.setOf_);
}

} // namespace ndframe
