#pragma once

#include <utility>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Many small sets of vertices (facets, cells), ordered so that equal sets stand together.
///
/// A counting sort by the smallest vertex and a sort within each bucket: linear in practice, no node-based container.
class VertexTuples
{
public:
  /// `tuples`: `width` vertex numbers each, in [0, numVertices); their order within a tuple does not matter.
  VertexTuples(std::vector<int> tuples, int width, int numVertices);

  int size() const { return int(order_.size()); } ///< number of tuples
  /// Tuple number at a place of the ordering.
  int at(int place) const { return order_[place]; }
  /// Its vertices, ascending.
  const int* tuple(int number) const { return tuples_.data() + std::size_t(number) * std::size_t(width_); }
  /// One past the last place whose tuple equals the one at `place`, which must be the first of its group.
  int groupEnd(int place) const;
  /// Places [first, second) of the tuples equal to `tuple` (which is sorted in place).
  std::pair<int, int> find(int* tuple) const;

private:
  bool less(const int* a, const int* b) const;

  int width_;
  std::vector<int> tuples_; ///< each sorted
  std::vector<int> order_;
  std::vector<int> bucket_; ///< numVertices + 1 places: where the tuples with a given smallest vertex begin
};

/// The facets of all cells; facet (cell, local) is tuple number (dim + 1) * cell + local.
VertexTuples allFacets(const Mesh& mesh, int numVertices);

} // namespace ndframe
