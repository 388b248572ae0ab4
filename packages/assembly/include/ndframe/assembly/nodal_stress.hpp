#pragma once

#include <array>
#include <vector>

#include "ndframe/assembly/fields.hpp"

namespace ndframe
{

/// The stress at every node as (xx, yy, zz, xy, yz, xz): the values of the cells around it, weighted by their measure.
/// A continuous picture of sigma_h; at a corner, under a jump of a load and between regions of different
/// materials it is a mean of values that differ.
/// displacement: numNodes * dim, global axes.
std::vector<std::array<double, 6>> nodalStress(const BodyModel& body, const Vector& displacement);

/// The largest strain of every cell: the largest absolute principal value of eps(u_h) (in the plane for dim 2). Strains
/// are at most linear in a cell, so it lies at a vertex.
struct CellStrain
{
  double value = 0.0; ///< dimensionless
  int vertex = 0;     ///< of the mesh
};
/// One for each of these cells.
std::vector<CellStrain> largestStrains(const BodyModel& body, const Vector& displacement, CellRange cells);

} // namespace ndframe
