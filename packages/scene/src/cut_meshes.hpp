#pragma once

#include "ndframe/base/params.hpp"
#include "ndframe/interface/insertion.hpp"

namespace ndframe
{

/// insertion(), with advice where solids cannot be cut: an InputError at `list`.
std::vector<DerivedMesh> cutMeshes(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& facing,
                                   const Params& list);

} // namespace ndframe
