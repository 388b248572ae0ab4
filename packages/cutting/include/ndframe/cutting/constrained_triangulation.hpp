#pragma once

#include <array>
#include <vector>

namespace ndframe
{

/// The constrained Delaunay triangulation of points in the plane: all its triangles, counterclockwise, up to the convex
/// hull of the points. Segments (by the numbers of their ends) are edges of it.
///
/// points: two coordinates each, none twice. Segments may share ends and may be given twice, but must not cross. By
/// CGAL (exact predicates), so that nearly collinear points do no harm.
/// Throws CannotCut where segments cross or points are one.
std::vector<std::array<int, 3>> constrainedTriangulation(const std::vector<std::array<double, 2>>& points,
                                                         const std::vector<std::array<int, 2>>& segments);

} // namespace ndframe
