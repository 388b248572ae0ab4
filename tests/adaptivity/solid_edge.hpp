#pragma once

#include "ndframe/algebra/comm.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe::test
{

constexpr int solidDegree = 2;

/// The cube between 0 and 1 of n^3 cubes, of six tetrahedra each; vertex 0 is the origin.
Mesh cubes(int n);

Mesh halvedEverywhere(const Mesh& mesh, int halvings);

/// eta_K of interpolating r^lambda around the edge x = y = 0, up to a constant: h^(2p+3) r^(2 lambda - 2 - 2p) with r
/// of the cell's centre.
Vector edgeContributions(const Mesh& mesh, double lambda);

} // namespace ndframe::test
