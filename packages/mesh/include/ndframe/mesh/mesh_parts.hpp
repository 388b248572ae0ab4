#pragma once

#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Takes parts out of a mesh, one after the other; each in time in proportion to the part and to the sides.
class MeshParts
{
public:
  explicit MeshParts(const Mesh& mesh); ///< which must live as long

  /// These cells with these points, which are all of theirs, in these orders. All sides are there, with the facets of
  /// these cells, and all names of groups.
  Mesh of(const std::vector<int>& cells, const std::vector<int>& points);

private:
  const Mesh& mesh_;
  std::vector<int> pointOf_, cellOf_; ///< -1 between two parts
};

/// The points of these cells, ascending.
std::vector<int> pointsOfCells(const Mesh& mesh, const std::vector<int>& cells);

} // namespace ndframe
