#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The local vertex opposite to the first refinement edge of every triangle of all meshes, one mesh after the other.
///
/// It is the longest edge. Lengths within 1e-8 of each other are equal: there edges are preferred that are a longest
/// one of both their triangles, so that marking one edge of a regular mesh does not run through the whole of it. What
/// is left is decided by position. edges: per triangle the edges opposite to its vertices, the same number for twins.
std::vector<int> firstPeaks(const std::vector<Mesh>& meshes, const std::vector<std::array<int, 3>>& edges,
                            int numEdges);

/// How many times better a shape must be for a mesh to be changed: less makes many changes for little, and many
/// different shapes; with 1.3 the halves of cells twice as long as high keep their refinement edges.
constexpr double clearly = 1.1;

/// The corners of a triangle, counterclockwise.
using Corners = std::array<const double*, 3>;

/// The local vertex opposite to the longest edge; the rightmost of equally long ones (within 1e-8).
int longestPeak(const Corners& corners);

/// The worst of the (at most four) triangleShapes of a triangle and all its descendants by newest-vertex bisection that
/// begins with the edge opposite to the peak.
///
/// With the squared edges c (the refinement edge), a and b they are 4 sqrt(3) area / s for
///   s = a + b + c,  3 a + b,  a + 3 b,  3 a + 3 b - c.
/// It is best for the longest edge, where it is at least 0.6 times the shape of the triangle itself; the half of a
/// square has the best of all. Negative for an inverted triangle.
double worstDescendant(const Corners& corners, int peak);

/// The peak opposite to the longest edge if the worst descendant becomes clearly better with it, otherwise the given
/// one.
int mendedPeak(const Corners& corners, int peak);

} // namespace ndframe
