#pragma once

#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The cells around every vertex of a triangular mesh, in order.
///
/// A corner is a vertex of a cell: number 3 * cell + local. Its first spoke leads to the next vertex of the cell, its
/// second to the one after (counterclockwise); the second spoke of a corner is the first of the one that follows in the
/// ring.
class Rings
{
public:
  explicit Rings(const Mesh& mesh);

  enum class Kind : unsigned char
  {
    Closed,
    Fan, ///< begins and ends on the boundary
    None ///< no cells, or cells that do not hang together through spokes
  };

  Kind kind(int vertex) const { return kind_[std::size_t(vertex)]; }
  int valence(int vertex) const { return start_[std::size_t(vertex) + 1] - start_[std::size_t(vertex)]; }
  const int* corners(int vertex) const { return corners_.data() + start_[std::size_t(vertex)]; }
  /// Place of the vertex of a corner among the cell's vertices in ascending order.
  int rank(int corner) const { return rank_[std::size_t(corner)]; }

  /// The corners of the same cell, counterclockwise.
  static int next(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static int previous(int corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

private:
  void order(const Mesh& mesh, int vertex);

  std::vector<int> start_, corners_;
  std::vector<Kind> kind_;
  std::vector<unsigned char> rank_;
};

} // namespace ndframe
