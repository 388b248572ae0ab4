#pragma once

#include "cut_meshes.hpp"
#include "match_sides.hpp"

namespace ndframe
{

/// Sides as they are drawn, before their edges were halved (Refine). Halved facets are the same polygon or polyhedron,
/// but n would turn along them in another way (normal_field.hpp): how it turns follows from the drawn ones.

/// Whether both sides have the same facets before they are halved.
bool matchAsDrawn(const FacingSides& sides, const std::vector<CutMesh>& meshes);

/// What a side of a plane body looks like: as drawn where n turns along it, else as `mesh`, the body's now, has it.
SidePolygon polygonAsDrawn(const CutMesh& body, const Mesh& mesh, const std::string& side, double cornerAngle);

/// The map between two sides that look so. first, second: the bodies' meshes now.
std::shared_ptr<const SideMap> mapAsDrawn(const FacingSides& sides, const std::vector<CutMesh>& meshes,
                                          const Mesh& first, const Mesh& second, double cornerAngle);

/// Whether n turns along one of a map's sides.
bool turns(const SideMap& map);

/// The first side as drawn, whose normals an interface without a map has; null where no edges were halved. In space
/// sides that do not match as drawn keep their triangles' own normals.
std::shared_ptr<const InterfaceMesh> firstSideAsDrawn(const FacingSides& sides, const std::vector<CutMesh>& meshes,
                                                      double cornerAngle);

} // namespace ndframe
