#include "ndframe/cutting/constrained_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "ndframe/cutting/cannot_cut.hpp"

namespace ndframe
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

} // namespace

std::vector<std::array<int, 3>> constrainedTriangulation(const std::vector<std::array<double, 2>>& points,
                                                         const std::vector<std::array<int, 2>>& segments)
{
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto near = vertices.empty() ? Triangulation::Face_handle() : vertices.back()->face();
    vertices.push_back(triangulation.insert(Kernel::Point_2(points[i][0], points[i][1]), near));
    vertices.back()->info() = int(i);
  }
  if (triangulation.number_of_vertices() != points.size())
    throw CannotCut("points of a triangulation are one");
  try {
    for (const auto& segment : segments)
      triangulation.insert_constraint(vertices[std::size_t(segment[0])], vertices[std::size_t(segment[1])]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw CannotCut("segments of a triangulation cross");
  }
  std::vector<std::array<int, 3>> triangles;
  for (const auto face : triangulation.finite_face_handles())
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

} // namespace ndframe
