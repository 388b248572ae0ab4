#include "gmsh_geometry.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/gmsh_converter.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{
namespace
{

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// What gmsh asks for wherever it needs a size.
double lengthAt(int, int, double x, double y, double, void* field)
{
  return static_cast<const LengthField*>(field)->at({x, y});
}

constexpr int line = 1; ///< gmsh's element type of two nodes

} // namespace

GmshGeometry::GmshGeometry(const MeshScript& script) : model_(script.file), regions_(script.regions)
{
  if (model_.dimension() != 2)
    throw FileError("the script makes solids now, and it made a plane mesh before.");
  const std::vector<int> surfaces = model_.entitiesOf(2, regions_);
  model_.showOnly(2, surfaces);
  for (const int surface : surfaces)
    for (const int curve : model_.boundaryOf(2, surface))
      free_.insert(curve);
}

Mesh GmshGeometry::mesh(const LengthField& lengths, const std::vector<FixedSide>& fixed, GmshAlgorithm algorithm,
                        const std::string& file)
{
  model_.setSizes(lengthAt, &lengths, int(algorithm));
  model_.session().generate(1);
  for (const FixedSide& side : fixed)
    fix(side);
  model_.session().generate(2);
  model_.session().write(file);
  return meshFromMsh(parseMsh(readText(file)), regions_);
}

void GmshGeometry::fix(const FixedSide& side)
{
  for (const int curve : model_.entitiesOf(1, {side.side}))
    if (free_.erase(curve) > 0)
      fixCurve(curve, side);
}

void GmshGeometry::fixCurve(int curve, const FixedSide& side)
{
  std::array<Node, 2> ends = endsOf(curve);
  if (ends[0].tag == ends[1].tag) // gmsh meshes its surface without the nodes given to it
    throw FileError(fmt::format("side \"{}\" has a curve that ends where it begins; make it of two arcs.", side.side));
  std::array<bool, 2> found{false, false};
  std::vector<CurvePoint> inside;
  for (const auto& [x, y] : side.points) {
    const CurvePoint here = project(curve, {x, y, ends[0].point[2]});
    bool atEnd = false;
    for (std::size_t e = 0; e < 2; ++e)
      if (distance(here.point, ends[e].point) <= side.tolerance) {
        ends[e].point = here.point;
        found[e] = atEnd = true;
      }
    if (!atEnd && here.distance <= side.tolerance)
      inside.push_back(here);
  }
  for (std::size_t e = 0; e < 2; ++e)
    if (!found[e])
      throw FileError(fmt::format("side \"{}\" has a corner at ({:g}, {:g}), the side that it touches has none there; "
                                  "give both scripts a Point at the same place.",
                                  side.side, ends[e].point[0], ends[e].point[1]));
  std::sort(inside.begin(), inside.end(),
            [](const CurvePoint& a, const CurvePoint& b) { return a.parameter < b.parameter; });
  replaceCurve(curve, inside, ends);
}

void GmshGeometry::replaceCurve(int curve, const std::vector<CurvePoint>& inside, std::array<Node, 2> ends)
{
  std::vector<double> points, parameters;
  for (const CurvePoint& here : inside) {
    points.insert(points.end(), here.point.begin(), here.point.end());
    parameters.push_back(here.parameter);
  }
  int error = 0, pair[2] = {1, curve};
  gmsh_.clearMesh(pair, 2, &error);
  for (Node& end : ends)
    gmsh_.setNode(end.tag, end.point.data(), 3, nullptr, 0, &error);
  gmsh_.addNodes(1, curve, nullptr, 0, points.data(), points.size(), parameters.data(), parameters.size(), &error);
  std::vector<std::size_t> lines{ends[0].tag};
  for (const Node& node : nodesOf(1, curve))
    lines.insert(lines.end(), {node.tag, node.tag});
  lines.push_back(ends[1].tag);
  gmsh_.addElements(curve, line, nullptr, 0, lines.data(), lines.size(), &error);
  model_.require(error);
}

std::vector<GmshGeometry::Node> GmshGeometry::nodesOf(int dim, int entity) const
{
  GmshArray<std::size_t> tags;
  GmshArray<double> points, parameters;
  int error = 0;
  gmsh_.nodes(&tags.data, &tags.size, &points.data, &points.size, &parameters.data, &parameters.size, dim, entity, 0, 0,
              &error);
  model_.require(error);
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < tags.size; ++i)
    nodes.push_back({tags.data[i], {points.data[3 * i], points.data[3 * i + 1], points.data[3 * i + 2]}});
  return nodes;
}

std::array<GmshGeometry::Node, 2> GmshGeometry::endsOf(int curve) const
{
  const std::vector<int> vertices = model_.boundaryOf(1, curve);
  NDFRAME_ASSERT(!vertices.empty(), "a curve has ends");
  std::array<Node, 2> ends{nodesOf(0, vertices.front()).at(0), nodesOf(0, vertices.back()).at(0)};
  if (project(curve, ends[0].point).parameter > project(curve, ends[1].point).parameter)
    std::swap(ends[0], ends[1]);
  return ends;
}

/// gmsh finds the nearest point of a curve to some 1e-9 only; Newton's method gives the other digits.
GmshGeometry::CurvePoint GmshGeometry::project(int curve, Point point) const
{
  GmshArray<double> nearest, parameter;
  int error = 0;
  gmsh_.closestPoint(1, curve, point.data(), 3, &nearest.data, &nearest.size, &parameter.data, &parameter.size, &error);
  model_.require(error);
  NDFRAME_ASSERT(parameter.size == 1, "a curve has one parameter");
  CurvePoint here{parameter.data[0], point, 0.0};
  for (int step = 0; step < 2; ++step) {
    GmshArray<double> x, tangent;
    gmsh_.value(1, curve, &here.parameter, 1, &x.data, &x.size, &error);
    gmsh_.derivative(1, curve, &here.parameter, 1, &tangent.data, &tangent.size, &error);
    model_.require(error);
    double along = 0.0, squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      along += (point[k] - x.data[k]) * tangent.data[k];
      squared += tangent.data[k] * tangent.data[k];
    }
    here.parameter += along / squared;
    here.distance = distance(point, {x.data[0], x.data[1], 0.0});
  }
  return here;
}

} // namespace ndframe
