#include "ndframe/equilibrium/wrench_flow.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/equilibrium/facet_twins.hpp"

namespace ndframe
{
namespace
{

/// sum += factor a x b
void addProduct(const Direction& a, const double* b, double factor, double* sum)
{
  sum[0] += factor * (a[1] * b[2] - a[2] * b[1]);
  sum[1] += factor * (a[2] * b[0] - a[0] * b[2]);
  sum[2] += factor * (a[0] * b[1] - a[1] * b[0]);
}

Direction between(const Direction& a, const Direction& b)
{
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

/// x of J x = b, J symmetric: xx, yy, zz, xy, xz, yz.
Direction solved(const std::array<double, 6>& J, const double* b)
{
  const double xx = J[1] * J[2] - J[5] * J[5], xy = J[4] * J[5] - J[3] * J[2], xz = J[3] * J[5] - J[4] * J[1],
               yy = J[0] * J[2] - J[4] * J[4], yz = J[3] * J[4] - J[0] * J[5], zz = J[0] * J[1] - J[3] * J[3],
               determinant = J[0] * xx + J[3] * xy + J[4] * xz;
  return {(xx * b[0] + xy * b[1] + xz * b[2]) / determinant, (xy * b[0] + yy * b[1] + yz * b[2]) / determinant,
          (xz * b[0] + yz * b[1] + zz * b[2]) / determinant};
}

} // namespace

void addMoved(const ForceMoment& wrench, const Direction& from, const Direction& to, ForceMoment& sum)
{
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] += wrench[i];
  addProduct(between(to, from), wrench.data(), 1.0, &sum[3]);
}

WrenchFlow::WrenchFlow(const Mesh& mesh) : faceOf_(std::size_t(mesh.numCells()) * 4, -1)
{
  const std::vector<SortedCell> cells = sortedCells(mesh);
  const std::vector<int> twins = facetTwins(cells, 3);
  Vector volumes;
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    centres_.push_back(cellCentre(mesh, cell));
    volumes.push_back(cellMeasure(mesh, cell));
  }
  for (int half = 0; half < int(twins.size()); ++half) {
    const int twin = twins[std::size_t(half)];
    if (twin < half)
      continue;
    const Facet facet{half / 4, cells[std::size_t(half / 4)].local[std::size_t(half % 4)]};
    double normal[3];
    const double area = facetNormal(mesh, facet, normal);
    faceOf_[std::size_t(half)] = faceOf_[std::size_t(twin)] = int(faces_.size());
    faces_.push_back({{half, twin},
                      facetCentre(mesh, facet),
                      std::sqrt(area),
                      area * area / (volumes[std::size_t(half / 4)] + volumes[std::size_t(twin / 4)])});
  }
  partOf_.assign(std::size_t(mesh.numCells()), -1);
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    if (partOf_[std::size_t(cell)] >= 0)
      continue;
    partOf_[std::size_t(cell)] = numParts();
    std::vector<int> part{cell};
    for (std::size_t at = 0; at < part.size(); ++at)
      for (int half = part[at] * 4; half < part[at] * 4 + 4; ++half)
        if (const int other = twins[std::size_t(half)] / 4;
            twins[std::size_t(half)] >= 0 && partOf_[std::size_t(other)] < 0) {
          partOf_[std::size_t(other)] = numParts();
          part.push_back(other);
        }
    parts_.push_back(std::move(part));
  }
}

/// One flow.
class WrenchFlow::Pass
{
public:
  Pass(const WrenchFlow& flow, std::vector<ForceMoment> lacks)
      : flow_(flow), lacks_(std::move(lacks)), through_(flow.faces_.size(), ForceMoment{}),
        set_(flow.centres_.size(), -1)
  {}

  std::vector<ForceMoment> run()
  {
    for (const std::vector<int>& part : flow_.parts_) {
      order_ = part;
      spare_.resize(part.size());
      open_.push_back({0, int(part.size())});
      while (!open_.empty()) {
        const Range range = open_.back();
        open_.pop_back();
        if (range.last - range.first > 1)
          halve(range);
      }
    }
    return std::move(through_);
  }

private:
  /// A face between two sets of a range.
  struct Link
  {
    int from, to, face;
  };

  void halve(Range range);
  void sortByPlace(Range range, int middle);
  std::vector<Range> hangingTogether(Range range, int middle);
  std::vector<Link> links(const std::vector<Range>& sets, int firstSet) const;
  ForceMoment needOf(Range range, const Direction& about) const;
  void spread(const std::vector<int>& faces, Range from);
  void send(int face, bool toFirst, const ForceMoment& wrench);
  int other(int half) const ///< the cell there, or -1
  {
    const int face = flow_.faceOf(half);
    const auto& halves = flow_.faces_[std::size_t(std::max(face, 0))].half;
    return face < 0 ? -1 : (halves[0] == half ? halves[1] : halves[0]) / 4;
  }

  const WrenchFlow& flow_;
  std::vector<ForceMoment> lacks_, through_;
  std::vector<int> order_, spare_, set_; ///< cells; per cell the set that it was last in
  std::vector<Range> open_;
  int numSets_ = 0;
};

/// A wrench on one of a face's cells, its opposite on the other.
void WrenchFlow::Pass::send(int number, bool toFirst, const ForceMoment& wrench)
{
  const Face& face = flow_.faces_[std::size_t(number)];
  ForceMoment& sum = through_[std::size_t(number)];
  for (std::size_t side = 0; side < 2; ++side) {
    const int cell = face.half[side] / 4;
    ForceMoment given = wrench;
    if ((side == 0) == toFirst)
      for (double& value : given)
        value = -value;
    addMoved(given, face.centre, flow_.centre(cell), lacks_[std::size_t(cell)]);
    for (std::size_t i = 0; i < sum.size() && side == 0; ++i)
      sum[i] -= given[i];
  }
}

/// The lower half by place along the longest extent comes first.
void WrenchFlow::Pass::sortByPlace(Range range, int middle)
{
  Direction low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (int at = range.first; at < range.last; ++at)
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = flow_.centre(order_[std::size_t(at)])[i];
      low[i] = std::min(low[i], place);
      high[i] = std::max(high[i], place);
    }
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (high[i] - low[i] > (1.0 + 1e-9) * (high[axis] - low[axis]))
      axis = i;
  const auto begin = order_.begin();
  std::nth_element(begin + range.first, begin + middle, begin + range.last, [&](int a, int b) {
    const double x = flow_.centre(a)[axis], y = flow_.centre(b)[axis];
    return x != y ? x < y : a < b;
  });
}

/// The sets of cells of both halves that hang together, one after the other; set_ numbers them from numSets_ on.
std::vector<WrenchFlow::Range> WrenchFlow::Pass::hangingTogether(Range range, int middle)
{
  for (int at = range.first; at < range.last; ++at)
    set_[std::size_t(order_[std::size_t(at)])] = at < middle ? -2 : -3;
  std::vector<Range> sets;
  int end = range.first;
  for (int at = range.first; at < range.last; ++at) {
    const int first = order_[std::size_t(at)], half = set_[std::size_t(first)];
    if (half >= 0)
      continue;
    sets.push_back({end, end});
    set_[std::size_t(first)] = numSets_;
    spare_[std::size_t(end++)] = first;
    for (int done = sets.back().first; done < end; ++done)
      for (int h = spare_[std::size_t(done)] * 4; h < spare_[std::size_t(done)] * 4 + 4; ++h)
        if (const int next = other(h); next >= 0 && set_[std::size_t(next)] == half) {
          set_[std::size_t(next)] = numSets_;
          spare_[std::size_t(end++)] = next;
        }
    sets.back().last = end;
    ++numSets_;
  }
  std::copy(spare_.begin() + range.first, spare_.begin() + range.last, order_.begin() + range.first);
  return sets;
}

/// All faces between the sets, both ways.
std::vector<WrenchFlow::Pass::Link> WrenchFlow::Pass::links(const std::vector<Range>& sets, int firstSet) const
{
  std::vector<Link> result;
  const int end = firstSet + int(sets.size());
  for (int at = sets.front().first; at < sets.back().last; ++at) {
    const int cell = order_[std::size_t(at)], own = set_[std::size_t(cell)];
    for (int half = cell * 4; half < cell * 4 + 4; ++half)
      if (const int next = other(half); next >= 0) {
        const int set = set_[std::size_t(next)];
        if (set != own && set >= firstSet && set < end)
          result.push_back({own - firstSet, set - firstSet, flow_.faceOf(half)});
      }
  }
  return result;
}

void WrenchFlow::Pass::halve(Range range)
{
  const int middle = (range.first + range.last) / 2, firstSet = numSets_;
  sortByPlace(range, middle);
  const std::vector<Range> sets = hangingTogether(range, middle);
  const std::vector<Link> all = links(sets, firstSet);
  std::vector<int> order{0}, parent(sets.size(), -1); // a tree of sets
  for (std::size_t at = 0; at < order.size(); ++at)
    for (const Link& link : all)
      if (link.to == order[at] && link.from != 0 && parent[std::size_t(link.from)] < 0) {
        parent[std::size_t(link.from)] = link.to;
        order.push_back(link.from);
      }
  for (std::size_t at = order.size() - 1; at > 0; --at) {
    std::vector<int> faces;
    for (const Link& link : all)
      if (link.from == order[at] && link.to == parent[std::size_t(link.from)])
        faces.push_back(link.face);
    spread(faces, sets[std::size_t(order[at])]);
  }
  open_.insert(open_.end(), sets.begin(), sets.end());
}

ForceMoment WrenchFlow::Pass::needOf(Range range, const Direction& about) const
{
  ForceMoment sum{};
  for (int at = range.first; at < range.last; ++at) {
    const int cell = order_[std::size_t(at)];
    addMoved(lacks_[std::size_t(cell)], flow_.centre(cell), about, sum);
  }
  return sum;
}

/// What a set lacks comes through faces with the springs F = s (a + b x (x - centre)), M = s size^2 b.
void WrenchFlow::Pass::spread(const std::vector<int>& faces, Range from)
{
  double total = 0.0;
  Direction centre{};
  for (const int number : faces) {
    const Face& face = flow_.faces_[std::size_t(number)];
    total += face.conductance;
    for (std::size_t i = 0; i < 3; ++i)
      centre[i] += face.conductance * face.centre[i];
  }
  for (double& value : centre)
    value /= total;
  std::array<double, 6> J{};
  for (const int number : faces) {
    const Face& face = flow_.faces_[std::size_t(number)];
    const Direction d = between(centre, face.centre);
    const double square = face.size * face.size + d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    for (std::size_t i = 0; i < 3; ++i)
      J[i] += face.conductance * (square - d[i] * d[i]);
    J[3] -= face.conductance * d[0] * d[1];
    J[4] -= face.conductance * d[0] * d[2];
    J[5] -= face.conductance * d[1] * d[2];
  }
  const ForceMoment need = needOf(from, centre);
  const Direction b = solved(J, &need[3]);
  for (const int number : faces) {
    const Face& face = flow_.faces_[std::size_t(number)];
    const Direction d = between(centre, face.centre);
    ForceMoment wrench{};
    for (std::size_t i = 0; i < 3; ++i) {
      wrench[i] = face.conductance / total * need[i];
      wrench[3 + i] = face.conductance * face.size * face.size * b[i];
    }
    addProduct(b, d.data(), face.conductance, wrench.data());
    const int firstSetOfLink = set_[std::size_t(face.half[0] / 4)];
    send(number, firstSetOfLink == set_[std::size_t(order_[std::size_t(from.first)])], wrench);
  }
}

std::vector<ForceMoment> WrenchFlow::through(std::vector<ForceMoment> lacks) const
{
  return Pass(*this, std::move(lacks)).run();
}

} // namespace ndframe
