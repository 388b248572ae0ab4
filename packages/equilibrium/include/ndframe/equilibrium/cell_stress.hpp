#pragma once

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// K eps(u) in a cell, linear (order 2) or constant: values at the vertices and the cell's gradients, vertices
/// ascending.
struct CellStress
{
  int dim = 0;           ///< of space
  double atVertex[4][6]; ///< stress, Voigt: 3 or 6 components a vertex
  double gradient[4][3]; ///< of the barycentric coordinates
  double measure = 0.0;  ///< area or volume
};

/// sigma_h = D eps(u_h) of a cell; displacement in global axes, node by node.
CellStress cellStress(const BodyModel& body, int cell, const SortedCell& sorted, const Vector& displacement);

/// f += factor * (stress at a vertex) times the gradient of a barycentric coordinate.
void addForce(const CellStress& stress, int vertex, int coordinate, double factor, double* f);

} // namespace ndframe
