#include "batched_rings.hpp"

#include <algorithm>

namespace ndframe
{

Rings::Rings(const Mesh& mesh)
    : start_(std::size_t(mesh.numPoints()) + 1, 0), corners_(mesh.cells.size()),
      kind_(std::size_t(mesh.numPoints()), Kind::None), rank_(mesh.cells.size())
{
  for (const int vertex : mesh.cells)
    ++start_[std::size_t(vertex) + 1];
  for (std::size_t v = 1; v < start_.size(); ++v)
    start_[v] += start_[v - 1];
  std::vector<int> end(start_.begin(), start_.end() - 1);
  for (int corner = 0; corner < int(mesh.cells.size()); ++corner)
    corners_[std::size_t(end[std::size_t(mesh.cells[std::size_t(corner)])]++)] = corner;
  for (std::size_t c = 0; c < mesh.cells.size(); c += 3) {
    const int *v = mesh.cells.data() + c, first = v[0], second = v[1], third = v[2];
    rank_[c] = static_cast<unsigned char>((second < first) + (third < first));
    rank_[c + 1] = static_cast<unsigned char>((first < second) + (third < second));
    rank_[c + 2] = static_cast<unsigned char>((first < third) + (second < third));
  }
  for (int vertex = 0; vertex < mesh.numPoints(); ++vertex)
    order(mesh, vertex);
}

/// Valences are small: neighbours are searched for.
void Rings::order(const Mesh& mesh, int vertex)
{
  int *begin = corners_.data() + start_[std::size_t(vertex)], *end = corners_.data() + start_[std::size_t(vertex) + 1];
  if (begin == end)
    return;
  const int* cells = mesh.cells.data();
  const auto isFirstOf = [&](int corner) {
    const int from = cells[next(corner)];
    return std::none_of(begin, end, [&](int other) { return cells[previous(other)] == from; });
  };
  int* const first = std::find_if(begin, end, isFirstOf);
  if (first != end)
    std::swap(*begin, *first);
  for (int* corner = begin; corner + 1 < end; ++corner) {
    const int to = cells[previous(*corner)];
    int* const follower = std::find_if(corner + 1, end, [&](int other) { return cells[next(other)] == to; });
    if (follower == end)
      return;
    std::swap(corner[1], *follower);
  }
  kind_[std::size_t(vertex)] = first != end ? Kind::Fan : Kind::Closed;
}

} // namespace ndframe
