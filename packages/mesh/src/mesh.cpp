#include "ndframe/mesh/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ndframe
{

namespace
{

using Vector = std::array<double, 3>;

/// Vector from point a to point b, padded with zeros to three components.
Vector difference(const Mesh& mesh, int a, int b)
{
  Vector d{};
  for (int i = 0; i < mesh.dim; ++i)
    d[i] = mesh.point(b)[i] - mesh.point(a)[i];
  return d;
}

Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

int CellGroups::findOrAdd(std::vector<std::string> groups)
{
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  const auto found = std::find(names.begin(), names.end(), groups);
  const int number = int(found - names.begin());
  if (found == names.end())
    names.push_back(std::move(groups));
  return number;
}

std::vector<char> CellGroups::kindsIn(const std::vector<std::string>& groups) const
{
  std::vector<char> isIn;
  for (const auto& ofKind : names)
    isIn.push_back(std::any_of(groups.begin(), groups.end(), [&](const std::string& group) {
      return std::binary_search(ofKind.begin(), ofKind.end(), group);
    }));
  return isIn;
}

bool CellGroups::has(const std::string& name) const
{
  const auto isIn = kindsIn({name});
  return std::any_of(isIn.begin(), isIn.end(), [](char value) { return value != 0; });
}

void CellGroups::inherit(const std::vector<int>& parents)
{
  if (kind.empty())
    return;
  std::vector<int> inherited;
  inherited.reserve(parents.size());
  for (const int parent : parents)
    inherited.push_back(kind[std::size_t(parent)]);
  kind = std::move(inherited);
}

const Side* Mesh::findSide(const std::string& name) const
{
  const auto found = std::find_if(sides.begin(), sides.end(), [&](const Side& side) { return side.name == name; });
  return found == sides.end() ? nullptr : &*found;
}

void cellPoints(const Mesh& mesh, int cell, double* points)
{
  for (int v = 0; v <= mesh.dim; ++v)
    std::copy_n(mesh.point(mesh.cell(cell)[v]), mesh.dim, points + std::ptrdiff_t(v) * mesh.dim);
}

void facetVertices(const Mesh& mesh, Facet facet, int* vertices)
{
  const int* cell = mesh.cell(facet.cell);
  for (int k = 0; k <= mesh.dim; ++k)
    if (k != facet.local)
      *vertices++ = cell[k];
}

double facetNormal(const Mesh& mesh, Facet facet, double* normal)
{
  std::array<int, 3> v{};
  facetVertices(mesh, facet, v.data());
  const Vector edge = difference(mesh, v[0], v[1]);
  // In two dimensions the cross product of the edge with the third unit vector; in three, of two edges.
  Vector area = mesh.dim == 2 ? Vector{edge[1], -edge[0], 0.0} : cross(edge, difference(mesh, v[0], v[2]));
  const double length = std::sqrt(dot(area, area));
  const int opposite = mesh.cell(facet.cell)[facet.local];
  const double sign = dot(area, difference(mesh, v[0], opposite)) > 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < mesh.dim; ++i)
    normal[i] = sign * area[i] / length;
  return mesh.dim == 2 ? length : length / 2;
}

std::array<double, 3> facetCentre(const Mesh& mesh, Facet facet)
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  std::array<double, 3> centre{};
  for (int v = 0; v < mesh.dim; ++v)
    for (int k = 0; k < mesh.dim; ++k)
      centre[std::size_t(k)] += mesh.point(vertices[v])[k] / mesh.dim;
  return centre;
}

std::array<double, 3> cellCentre(const Mesh& mesh, int cell)
{
  std::array<double, 3> centre{};
  for (int v = 0; v <= mesh.dim; ++v)
    for (int k = 0; k < mesh.dim; ++k)
      centre[std::size_t(k)] += mesh.point(mesh.cell(cell)[v])[k] / (mesh.dim + 1);
  return centre;
}

double cellMeasure(const Mesh& mesh, int cell)
{
  const int* v = mesh.cell(cell);
  const Vector a = difference(mesh, v[0], v[1]);
  const Vector b = difference(mesh, v[0], v[2]);
  if (mesh.dim == 2)
    return (a[0] * b[1] - a[1] * b[0]) / 2;
  return dot(cross(a, b), difference(mesh, v[0], v[3])) / 6;
}

void dropRoundOff(std::vector<double>& coordinates, double extent)
{
  for (double& coordinate : coordinates)
    if (std::abs(coordinate) < std::numeric_limits<double>::epsilon() * extent)
      coordinate = 0.0;
}

double diameter(const Mesh& mesh)
{
  double squares = 0.0;
  for (int i = 0; i < mesh.dim && mesh.numPoints() > 0; ++i) {
    double low = mesh.point(0)[i];
    double high = low;
    for (int p = 1; p < mesh.numPoints(); ++p) {
      low = std::min(low, mesh.point(p)[i]);
      high = std::max(high, mesh.point(p)[i]);
    }
    squares += (high - low) * (high - low);
  }
  return std::sqrt(squares);
}

} // namespace ndframe
