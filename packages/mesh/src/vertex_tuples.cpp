#include "ndframe/mesh/vertex_tuples.hpp"

#include <algorithm>

namespace ndframe
{

VertexTuples::VertexTuples(std::vector<int> tuples, int width, int numVertices)
    : width_(width), tuples_(std::move(tuples)), order_(tuples_.size() / std::size_t(width)),
      bucket_(std::size_t(numVertices) + 1, 0)
{
  for (int t = 0; t < size(); ++t) {
    int* first = tuples_.data() + std::size_t(t) * std::size_t(width_);
    std::sort(first, first + width_);
    ++bucket_[first[0] + 1];
  }
  for (int v = 0; v < numVertices; ++v)
    bucket_[v + 1] += bucket_[v];

  std::vector<int> next(bucket_.begin(), bucket_.end() - 1);
  for (int t = 0; t < size(); ++t)
    order_[next[tuple(t)[0]]++] = t;
  const auto before = [this](int a, int b) { // in a bucket the first vertices are the same
    const int *first = tuple(a), *second = tuple(b);
    for (int i = 1; i < width_; ++i)
      if (first[i] != second[i])
        return first[i] < second[i];
    return a < b;
  };
  for (int v = 0; v < numVertices; ++v)
    std::sort(order_.begin() + bucket_[v], order_.begin() + bucket_[v + 1], before);
}

bool VertexTuples::less(const int* a, const int* b) const
{
  return std::lexicographical_compare(a, a + width_, b, b + width_);
}

int VertexTuples::groupEnd(int place) const
{
  int end = place + 1;
  while (end < size() && std::equal(tuple(order_[place]), tuple(order_[place]) + width_, tuple(order_[end])))
    ++end;
  return end;
}

std::pair<int, int> VertexTuples::find(int* wanted) const
{
  std::sort(wanted, wanted + width_);
  const auto first = order_.begin() + bucket_[wanted[0]];
  const auto last = order_.begin() + bucket_[wanted[0] + 1];
  const auto low = std::lower_bound(first, last, wanted, [this](int t, const int* w) { return less(tuple(t), w); });
  const auto high = std::upper_bound(low, last, wanted, [this](const int* w, int t) { return less(w, tuple(t)); });
  return {int(low - order_.begin()), int(high - order_.begin())};
}

VertexTuples allFacets(const Mesh& mesh, int numVertices)
{
  const int facets = mesh.dim + 1;
  std::vector<int> tuples(std::size_t(mesh.numCells()) * std::size_t(facets) * std::size_t(mesh.dim));
  int* next = tuples.data();
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int local = 0; local < facets; ++local, next += mesh.dim)
      facetVertices(mesh, {c, local}, next);
  return VertexTuples(std::move(tuples), mesh.dim, numVertices);
}

} // namespace ndframe
