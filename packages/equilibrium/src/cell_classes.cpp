#include "ndframe/equilibrium/cell_classes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{
namespace
{

using Shape = std::array<std::int64_t, 11>; ///< edge vectors in units of a cell's size, body, law

struct HashOfShape
{
  std::size_t operator()(const Shape& shape) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t entry : shape)
      hash = (hash ^ std::uint64_t(entry)) * 0x9E3779B97F4A7C15U ^ hash >> 29;
    return std::size_t(hash);
  }
};

/// Fills in the edge vectors of a shape; returns the longest coordinate difference.
double measureShape(const Mesh& mesh, int cell, Shape& shape)
{
  constexpr double units = 17592186044416.0; // 2^44
  const SortedCell sorted = sortedCell(mesh, cell);
  const double* origin = mesh.point(sorted.vertices[0]);
  std::array<double, 9> edges{};
  double length = 0.0;
  for (std::size_t at = 0; at < edges.size(); ++at) {
    edges[at] = mesh.point(sorted.vertices[at / 3 + 1])[at % 3] - origin[at % 3];
    length = std::max(length, std::abs(edges[at]));
  }
  for (std::size_t at = 0; at < edges.size(); ++at)
    shape[at] = std::llround(edges[at] / length * units);
  return length;
}

} // namespace

CellClasses::CellClasses(const std::vector<const BodyModel*>& bodies)
{
  std::unordered_map<Shape, int, HashOfShape> known;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int cell = 0; bodies[b] != nullptr && cell < bodies[b]->mesh.numCells(); ++cell) {
      Shape shape{};
      length_.push_back(measureShape(bodies[b]->mesh, cell, shape));
      shape[9] = std::int64_t(b);
      shape[10] = bodies[b]->laws.number(cell);
      const auto [place, isNew] = known.emplace(shape, size());
      if (isNew) {
        first_.push_back(int(of_.size()));
        count_.push_back(0);
      }
      of_.push_back(place->second);
      ++count_[std::size_t(place->second)];
    }
}

CellClasses CellClasses::among(const std::vector<int>& cells) const
{
  std::vector<int> place(first_.size(), -1);
  for (const int cell : cells)
    place[std::size_t(of(cell))] = 0;
  CellClasses some;
  for (int number = 0; number < size(); ++number)
    if (place[std::size_t(number)] == 0) {
      place[std::size_t(number)] = int(some.origin_.size());
      some.origin_.push_back(origin(number));
      some.count_.push_back(count(number));
    }
  some.first_.assign(some.origin_.size(), -1);
  some.hasOrigin_.assign(some.origin_.size(), 0);
  for (const int cell : cells) {
    const int number = place[std::size_t(of(cell))];
    if (some.first_[std::size_t(number)] < 0) {
      some.first_[std::size_t(number)] = int(some.of_.size());
      some.hasOrigin_[std::size_t(number)] = char(cell == some.origin_[std::size_t(number)]);
    }
    some.of_.push_back(number);
    some.length_.push_back(length_[std::size_t(cell)]);
  }
  return some;
}

} // namespace ndframe
