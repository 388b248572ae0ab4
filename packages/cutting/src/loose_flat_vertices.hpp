#pragma once

#include <map>

#include "ndframe/mesh/vertex_cells.hpp"
#include "side_topology.hpp"

namespace ndframe
{

/// The vertices of a solid's side that may be moved without changing the body or where any of its named sides ends: in
/// their plane where the boundary around them is flat and belongs to the same sides, along a straight line where two
/// such parts meet.
class LooseFlatVertices
{
public:
  LooseFlatVertices(Mesh& mesh, const std::string& side);

  void keep(int vertex) { ways_.erase(vertex); }
  bool isFixed(int vertex) const { return ways_.count(vertex) == 0; }
  /// Moves a vertex of the side within its plane; false where it must stay, or where a cell would become flat.
  bool move(int vertex, const Vector3& to);

private:
  Mesh& mesh_;
  VertexCells cells_;
  std::map<int, Vector3> ways_;  ///< per vertex its line; zero where all of the plane is free
  std::map<int, double> shapes_; ///< of cells that have changed: what they had at first
};

/// Moves vertices of two sides of solids to a vertex of the other side, else onto an edge of it, that is within a fifth
/// of the shortest edges there: those of the second side, or, where one must stay, of the first. So fewer small cells
/// come about when the sides are cut. Returns which of the two meshes were changed.
std::array<bool, 2> moveFlatVertices(Mesh& first, const std::string& firstSide, Mesh& second,
                                     const std::string& secondSide);

} // namespace ndframe
