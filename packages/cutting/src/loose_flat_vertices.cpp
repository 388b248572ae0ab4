#include "loose_flat_vertices.hpp"

#include <algorithm>

#include "creases.hpp"
#include "flat_pairs.hpp"
#include "ndframe/mesh/shape.hpp"

namespace ndframe
{
namespace
{

/// A move must leave every cell this part of the shape that it had at first, unless it stays as good as that.
constexpr double worseShape = 0.5, goodShape = 0.4;
/// A move leaves a line by less: round-off.
constexpr double sameLine = 1e-9;

double shapeOf(const Mesh& mesh, int cell)
{
  const int* v = mesh.cell(cell);
  return tetrahedronShape(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
}

} // namespace

LooseFlatVertices::LooseFlatVertices(Mesh& mesh, const std::string& side) : mesh_(mesh), cells_(mesh)
{
  ways_ = looseVertices(mesh, mesh.findSide(side)->facets, creases(mesh));
}

bool LooseFlatVertices::move(int vertex, const Vector3& to)
{
  const auto way = ways_.find(vertex);
  if (way == ways_.end())
    return false;
  double* x = mesh_.points.data() + std::ptrdiff_t(vertex) * 3;
  const Vector3 from{x[0], x[1], x[2]}, by = minus(to, from);
  if (const double length = norm(way->second);
      length > 0.0 && norm(crossProduct(by, way->second)) > sameLine * length * length)
    return false;
  for (const int* cell = cells_.begin(vertex); cell != cells_.end(vertex); ++cell)
    shapes_.insert({*cell, shapeOf(mesh_, *cell)});
  std::copy(to.begin(), to.end(), x);
  for (const int* cell = cells_.begin(vertex); cell != cells_.end(vertex); ++cell)
    if (const double shape = shapeOf(mesh_, *cell); shape < goodShape && shape < worseShape * shapes_.at(*cell)) {
      std::copy(from.begin(), from.end(), x);
      return false;
    }
  return true;
}

} // namespace ndframe
