#pragma once

#include <memory>

#include "ndframe/base/list_place.hpp"
#include "ndframe/interface/insertion.hpp"

namespace ndframe
{

/// The map of two sides in the plane that exist. cornerAngle: as in SidePolygon.
std::shared_ptr<const SideMap> mapBetween(const FacingSides& sides, const Mesh& first, const Mesh& second,
                                          double cornerAngle);

/// insertion(), with advice where solids cannot be cut: an InputError at `list`.
std::vector<DerivedMesh> cutMeshes(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& facing,
                                   const ListPlace& list);

} // namespace ndframe
