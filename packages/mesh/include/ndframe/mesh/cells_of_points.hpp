#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A point in a cell by its barycentric coordinates, dim + 1 of them.
struct PointInCell
{
  int cell = -1;                  ///< number in the mesh
  std::array<double, 4> lambda{}; ///< in the order of the cell's vertices, their sum is 1
  double outside = 0.0;           ///< how far the point is outside of a cell that does not hold it, see cellsOfPoints
};

/// The cells in which each point lies, in ascending order: one inside, several on a face, an edge or at a vertex, to
/// round-off of the cells' size. A point in none gets the first of the cells that it is least outside of - by its
/// distances from the planes of the cell's faces, which is at most its distance from the cell - if that is no more than
/// `tolerance`; a coordinate is negative then. Empty for points farther out. Points: dim coordinates each. numCells:
/// only the first cells are looked at; -1: all.
///
/// In the plane and in space; points are sorted, so that cells are looked at once: O(cells log points), and what lies
/// in their boxes along x.
std::vector<std::vector<PointInCell>> cellsOfPoints(const Mesh& mesh, const std::vector<std::vector<double>>& points,
                                                    double tolerance, int numCells = -1);

/// Where a point in a cell is: dim coordinates.
std::vector<double> pointAt(const Mesh& mesh, const PointInCell& place);

} // namespace ndframe
