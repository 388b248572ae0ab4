#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A point of a drawn mesh whose edges were halved again and again: x = sum_i weights_i x_i / sum_i weights_i, x_i the
/// vertices of the drawn mesh that it lies between (one at a vertex, two on an edge, ...), ascending, weights positive.
struct DrawnPlace
{
  std::array<int, 4> vertices{}; ///< the first `count`
  std::array<int, 4> weights{};  ///< the same
  int count = 0;                 ///< 1 to dim + 1

  static DrawnPlace vertex(int v) { return {{v}, {1}, 1}; }
  /// Halfway between two points whose weights have the same sum; that of the result is twice as large.
  static DrawnPlace middle(const DrawnPlace& a, const DrawnPlace& b);
  DrawnPlace doubled() const { return middle(*this, *this); } ///< the same point
};

/// Numbers of the points of a mesh after k halvings (refineUniformly), and of the middles of its edges, which follow
/// them: what a part of the refined mesh calls them without knowing the rest. Points lie at the lattice of order
/// n = 2^k of the drawn cells, middles at the other points of that of order 2 n; inside each vertex, edge, facet and
/// cell of the drawn mesh they are counted in lexicographic order of their weights:
///
///   C(n - 1, m - 1) points inside a simplex with m vertices,  C(2 n - 1, m - 1) - C(n - 1, m - 1) middles.
///
/// Numbers are ascending from 0 without holes, and have 64 bits.
class RefinedNumbers
{
public:
  using Number = std::int64_t;
  /// What a part of the drawn mesh does not show of the whole.
  struct Whole
  {
    Number cells = 0;                           ///< of the drawn mesh
    std::array<Number, 4> counts{};             ///< per number of vertices less one: its simplices
    std::array<std::vector<Number>, 4> numbers; ///< the same: per simplex of the part that among all
    std::vector<Number> ofCells;                ///< per cell of the part its place in the drawn mesh
  };

  RefinedNumbers(const Mesh& drawn, int halvings);
  /// The same numbers, of places in a part of the drawn mesh, by its vertices, which ascend as in the whole.
  RefinedNumbers(const Mesh& part, int halvings, Whole whole);
  /// What such a part must be told. vertices, cells: per vertex and cell of the part that of this mesh, ascending.
  Whole toldTo(const Mesh& part, const std::vector<int>& vertices, const std::vector<int>& cells) const;

  Number point(const DrawnPlace& place) const;  ///< weights add up to 2^k
  Number middle(const DrawnPlace& place) const; ///< weights add up to 2^(k + 1), not all are even
  /// The place in the whole drawn mesh of one of its cells.
  Number cell(int drawn) const { return whole_.ofCells.empty() ? drawn : whole_.ofCells[std::size_t(drawn)]; }
  Number numPoints() const { return numPoints_; }
  Number numMiddles() const { return numMiddles_; }
  Number numCells() const { return numCells_; }
  /// Adds to `counts`, by the order of vertices, the points and middles inside the drawn simplices whose first vertex
  /// has this order. order: per drawn vertex.
  void countNodes(const std::vector<int>& order, std::vector<double>& counts) const;

private:
  void listSimplices(const Mesh& mesh, int most);
  void count(int dim, int halvings);
  /// The number of the drawn vertex, edge, ... in the list of its kind.
  Number simplex(const DrawnPlace& place) const;

  Number order_, numPoints_ = 0, numMiddles_ = 0, numCells_ = 0;
  Whole whole_; ///< without numbers where the mesh is the whole
  /// Per number of vertices less one: the drawn simplices by their vertices, ascending; none of vertices themselves,
  /// nor of those that have no points inside.
  std::array<std::vector<std::array<int, 4>>, 4> simplices_;
  std::array<Number, 4> firstPoint_{}, firstMiddle_{}; ///< the same, of the first simplex
};

/// All simplices of so many vertices (2 to dim + 1) in a mesh, by their vertices, ascending; the rest of the four is
/// larger than any.
std::vector<std::array<int, 4>> simplicesOf(const Mesh& mesh, int count);
/// Of how many vertices those simplices have at most that have points or middles inside.
int mostVertices(int dim, int halvings);

} // namespace ndframe
