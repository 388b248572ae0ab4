#pragma once

#include <functional>
#include <string>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe::test
{

/// The rectangle [0,2] x [bottom, bottom+1] of four triangles, or the box [0,1]^2 x [bottom, bottom+1] of six
/// tetrahedra. Sides "low" and "high" in the last direction, "all" around, and "none" without facets.
Mesh sampleMesh(int dim, double bottom);

/// The boundary facets whose vertices all satisfy `contains`.
Side sideWhere(const Mesh& mesh, const std::string& name, const std::function<bool(const double* point)>& contains);

} // namespace ndframe::test
