#pragma once

#include <array>
#include <vector>

namespace ndframe
{

/// A surface of triangles in space, a polyhedron that may stand for a curved surface.
struct TriangleSurface
{
  using Vector3 = std::array<double, 3>; ///< x, y, z
  std::vector<Vector3> points;           ///< by number
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vector3> normals; ///< of the triangles, of length 1, all on the same side
};

/// The direction n of a curved surface at the vertices of every triangle, so that it is linear in between and
/// continuous but across edges where the polyhedron turns by more than `cornerAngle` (degrees).
///
/// The triangles around a vertex form fans, up to such edges and the border. Where a fan closes, n is the normal of the
/// quadric through the vertex that lies nearest to its neighbours: right on spheres and cylinders, else up to the third
/// power of the angles between triangles. In open fans, and where neighbours lie so that no quadric is nearest, n
/// follows from known neighbours w: a chord e of a quadric has n_v . e = - n_w . e. What is left takes the flattest
/// quadric.
///
/// n is so long that its parts along the triangles' normals are 1 in the mean, and of one length on every part without
/// an edge, so that n . (omega x x) = 0 on all of a sphere or cylinder for its rotations.
///
/// Fans that are flat (up to 1e-6) keep the triangles' normal, but for open ones whose triangles all turn elsewhere:
/// they are the end of a curved part. So do those in which no direction is within 60 degrees of all normals (the peak
/// of a needle). Zero on triangles that keep their own normal at all three vertices; empty where all do.
std::vector<std::array<TriangleSurface::Vector3, 3>> turningNormals(const TriangleSurface& surface, double cornerAngle);

} // namespace ndframe
