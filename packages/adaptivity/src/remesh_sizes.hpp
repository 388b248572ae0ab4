#pragma once

#include "ndframe/adaptivity/size_field.hpp"

namespace ndframe
{

/// Lengths of edges, at the vertices of `parts`, of equilateral triangles or regular tetrahedra with the measures that
/// are wanted for the parts of the cells of `mesh`: the geometric mean of the cells around a vertex. ancestors: per
/// part. Cells may have edges of twice the length that they have in `mesh`.
std::vector<double> lengthsOn(const Mesh& parts, const std::vector<int>& ancestors, const Mesh& mesh,
                              const std::vector<CellSize>& sizes);

} // namespace ndframe
