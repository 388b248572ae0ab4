#include "gmsh_geometry.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "file_error.hpp"
#include "gmsh_converter.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "steady_file.hpp"

namespace ndframe
{
namespace
{

/// An array that gmsh allocates.
template <class T>
struct GmshArray
{
  GmshArray() = default;
  ~GmshArray() { GmshFunctions::get().free(data); }
  GmshArray(const GmshArray&) = delete;
  GmshArray& operator=(const GmshArray&) = delete;
  const T* begin() const { return data; }
  const T* end() const { return data + size; }

  T* data = nullptr;
  std::size_t size = 0;
};

/// gmsh's pairs of a dimension and a tag.
std::vector<int> dimTags(int dim, const std::vector<int>& tags)
{
  std::vector<int> pairs;
  for (const int tag : tags)
    pairs.insert(pairs.end(), {dim, tag});
  return pairs;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// What gmsh asks for wherever it needs a size.
double lengthAt(int, int, double x, double y, double, void* field)
{
  return static_cast<const LengthField*>(field)->at({x, y});
}

/// gmsh integrates sizes along curves to 1e-9 if it is not told otherwise, which takes longer than to make the mesh.
constexpr double curvePrecision = 1e-5;
constexpr int line = 1; ///< gmsh's element type of two nodes

} // namespace

GmshGeometry::GmshGeometry(const MeshScript& script) : regions_(script.regions)
{
  session_.open(script.file);
  if (session_.dimension() != 2)
    throw FileError("remeshing works in two dimensions only.");
  forgetOwnSizes();
  showOnly(entitiesOf(2, regions_));
}

std::vector<int> GmshGeometry::entitiesOf(int dim, const std::vector<std::string>& groups) const
{
  std::vector<int> tags;
  GmshArray<int> pairs;
  int error = 0;
  gmsh_.groups(&pairs.data, &pairs.size, dim, &error);
  for (std::size_t i = 1; i < pairs.size; i += 2) {
    GmshArray<char> name;
    gmsh_.groupName(dim, pairs.data[i], &name.data, &error);
    if (std::find(groups.begin(), groups.end(), gmshGroupName(name.data, pairs.data[i])) == groups.end())
      continue;
    GmshArray<int> entities;
    gmsh_.groupEntities(dim, pairs.data[i], &entities.data, &entities.size, &error);
    tags.insert(tags.end(), entities.begin(), entities.end());
  }
  require(error);
  return tags;
}

std::vector<int> GmshGeometry::boundaryOf(int dim, const std::vector<int>& tags) const
{
  std::vector<int> pairs = dimTags(dim, tags);
  GmshArray<int> boundary;
  int error = 0;
  gmsh_.boundary(pairs.data(), pairs.size(), &boundary.data, &boundary.size, 0, 0, 0, &error);
  require(error);
  std::vector<int> found;
  for (std::size_t i = 1; i < boundary.size; i += 2)
    found.push_back(std::abs(boundary.data[i]));
  return found;
}

void GmshGeometry::showOnly(const std::vector<int>& surfaces)
{
  GmshArray<int> all;
  int error = 0;
  gmsh_.entities(&all.data, &all.size, 2, &error);
  std::vector<int> shown = dimTags(2, surfaces);
  if (surfaces.empty())
    shown.assign(all.begin(), all.end());
  gmsh_.setVisibility(all.data, all.size, 0, 1, &error);
  gmsh_.setVisibility(shown.data(), shown.size(), 1, 1, &error); // also what it shares with others
  require(error);
  session_.setNumber("Mesh.MeshOnlyVisible", 1);
  for (std::size_t i = 1; i < shown.size(); i += 2)
    for (const int curve : boundaryOf(2, {shown[i]}))
      free_.insert(curve);
}

void GmshGeometry::forgetOwnSizes()
{
  for (const char* option :
       {"Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints", "Mesh.MeshSizeFromCurvature", "Mesh.MeshSizeMin"})
    session_.setNumber(option, 0);
  session_.setNumber("Mesh.MeshSizeMax", 1e22);
  session_.setNumber("Mesh.MeshSizeFactor", 1);
  session_.setNumber("Mesh.ElementOrder", 1);
  session_.setNumber("Mesh.LcIntegrationPrecision", curvePrecision);
  int error = 0;
  gmsh_.clearMesh(nullptr, 0, &error); // of a script that meshes
  gmsh_.setBackground(0, &error);
  require(error);
}

Mesh GmshGeometry::mesh(const LengthField& lengths, const std::vector<FixedSide>& fixed, GmshAlgorithm algorithm,
                        const std::string& file)
{
  session_.setNumber("Mesh.Algorithm", double(algorithm));
  int error = 0;
  gmsh_.setSizeCallback(lengthAt, const_cast<LengthField*>(&lengths), &error);
  require(error);
  session_.generate(1);
  for (const FixedSide& side : fixed)
    fix(side);
  session_.generate(2);
  session_.write(file);
  return meshFromMsh(parseMsh(readText(file)), regions_);
}

void GmshGeometry::fix(const FixedSide& side)
{
  for (const int curve : entitiesOf(1, {side.side}))
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
  require(error);
}

std::vector<GmshGeometry::Node> GmshGeometry::nodesOf(int dim, int entity) const
{
  GmshArray<std::size_t> tags;
  GmshArray<double> points, parameters;
  int error = 0;
  gmsh_.nodes(&tags.data, &tags.size, &points.data, &points.size, &parameters.data, &parameters.size, dim, entity, 0, 0,
              &error);
  require(error);
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < tags.size; ++i)
    nodes.push_back({tags.data[i], {points.data[3 * i], points.data[3 * i + 1], points.data[3 * i + 2]}});
  return nodes;
}

std::array<GmshGeometry::Node, 2> GmshGeometry::endsOf(int curve) const
{
  const std::vector<int> vertices = boundaryOf(1, {curve});
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
  require(error);
  NDFRAME_ASSERT(parameter.size == 1, "a curve has one parameter");
  CurvePoint here{parameter.data[0], point, 0.0};
  for (int step = 0; step < 2; ++step) {
    GmshArray<double> x, tangent;
    gmsh_.value(1, curve, &here.parameter, 1, &x.data, &x.size, &error);
    gmsh_.derivative(1, curve, &here.parameter, 1, &tangent.data, &tangent.size, &error);
    require(error);
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
