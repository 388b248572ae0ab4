#pragma once

#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// The direction n along which two sides may not come closer, where their polygon or polyhedron stands for a curve or a
/// curved surface: continuous, linear along every facet between the values at its vertices.
///
/// In space: turningNormals() (surface_normals.hpp), in which edges are what corners are here. In the plane:
///
/// At a vertex n points along the radius of the circle through it and its neighbours (the facets' normals weighted by
/// each other's lengths) and is so long that its parts along the two facets' normals are 1 in the mean: on equal chords
/// of a circle they are 1 everywhere, so that the traction t n is the pressure -t and a traction along the facet.
///
/// A vertex where the side turns by more than `cornerAngle` (degrees) is a corner: n jumps there, as it may where the
/// side goes straight on (up to 1e-6). At corners and ends of a side a facet has the value of its other vertex mirrored
/// at its own normal. Facets without a vertex that turns keep their own normal.
///
/// Sets endNormals and the normals at the nodes of turning facets (at corners they stay the mean); nothing on sides
/// that do not turn.
void turnNormals(InterfaceMesh& mesh, const Mesh& dirichletMesh, double cornerAngle);

/// Gives the nodes the values of endNormals where these are one value.
void setNodeNormals(InterfaceMesh& mesh);

/// Gives every corner inside a side, where two facets of the plane meet at more than `cornerAngle`, a second node with
/// the same body nodes, so that each facet keeps its own normal there: two conditions on one pair of nodes. Not with an
/// angle of 0, where every vertex would be a corner and a curved side could not slip. maySplit: per interface node,
/// false where it has to stay one. In the plane only.
void splitCorners(InterfaceMesh& mesh, const Mesh& dirichletMesh, double cornerAngle,
                  const std::vector<char>& maySplit);

/// One side with the vertices of its facets and their normals (turnNormals), without the other side.
InterfaceMesh sideAlone(const Mesh& mesh, const std::vector<Facet>& facets, double cornerAngle);

/// Gives a mesh the normals of another one of the same polygon, whose facets contain its facets: the condition of
/// contact stays the same function. Where the other one keeps its facets' own, this one does. `earlier` may look from
/// the other body. False, and nothing is changed, where `mesh` does not lie on the polygon (up to 1e-6 of its facets),
/// as when a curve was meshed anew.
bool inheritNormals(InterfaceMesh& mesh, const InterfaceMesh& earlier);

} // namespace ndframe
