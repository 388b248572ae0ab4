#include "ndframe/drawing/drawn_checks.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/boundary.hpp"
#include "ndframe/mesh/cell_locator.hpp"

namespace ndframe
{

namespace
{

/// A cell of each part of a mesh that shares no facet with the others.
std::vector<int> cellOfEachPart(const Mesh& mesh)
{
  std::vector<int> parent(std::size_t(mesh.numCells()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int cell) {
    while (parent[std::size_t(cell)] != cell)
      cell = parent[std::size_t(cell)] = parent[std::size_t(parent[std::size_t(cell)])];
    return cell;
  };
  for (const auto& [cell, neighbour] : neighbourCells(mesh))
    parent[std::size_t(root(cell))] = root(neighbour);
  std::vector<int> cells;
  for (int c = 0; c < mesh.numCells(); ++c)
    if (root(c) == c)
      cells.push_back(c);
  return cells;
}

const char* nameOfBodies(int dim)
{
  return dim == 2 ? "Physical Surface" : "Physical Volume";
}

} // namespace

void refuseNamelessSides(const DrawnAssembly& scene)
{
  if (std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const DrawnBody& body) { return !body.sides.empty(); }))
    return;
  const bool isPlane = scene.dim == 2;
  const std::string bodies = scene.bodies.front().isWholeFile
                                 ? fmt::format(", and {}(\"block\") = {{1}}; for each body", nameOfBodies(scene.dim))
                                 : "";
  throw InputError(fmt::format("no side has a name: write Physical {}(\"table\") = {{3}}; for the {} that are held, "
                               "loaded or may touch{}. gmsh shows their numbers: Tools, Options, Geometry, {} labels.",
                               isPlane ? "Curve" : "Surface", isPlane ? "curves" : "surfaces", bodies,
                               isPlane ? "Curve" : "Surface"));
}

void refuseUnconnectedParts(const DrawnAssembly& scene)
{
  for (const DrawnBody& body : scene.bodies) {
    const auto cells = cellOfEachPart(body.mesh);
    if (cells.size() < 2)
      continue;
    const auto place = [&](int cell) { return pointText(cellCentre(body.mesh, cell).data(), scene.dim); };
    const std::string what = body.isWholeFile ? fmt::format("the drawing has no {}, and", nameOfBodies(scene.dim))
                                              : fmt::format("\"{}\" has", body.name);
    throw InputError(fmt::format(
        "{} {} parts that share no {}, at {} and {}: write {}(\"block\") = {{1}}; with a separate name for each.", what,
        cells.size(), scene.dim == 2 ? "edge" : "face", place(cells[0]), place(cells[1]), nameOfBodies(scene.dim)));
  }
}

void refuseNamesOfLists(const std::vector<std::string>& bodies)
{
  for (const std::string& name : bodies)
    if (name.find_first_of(",{}") != std::string::npos)
      throw InputError(fmt::format("the name \"{}\" of a body has a comma or a brace, which stand for lists in a deck; "
                                   "call it something else.",
                                   name));
}

std::optional<DrawnOverlap> overlapOf(const DrawnAssembly& scene)
{
  for (const DrawnBody& within : scene.bodies) {
    const CellLocator locator(within.mesh);
    for (const DrawnBody& body : scene.bodies)
      for (int c = 0; &body != &within && c < body.mesh.numCells(); ++c)
        if (const auto centre = cellCentre(body.mesh, c); locator.find({centre[0], centre[1]}).squaredDistance == 0.0)
          return DrawnOverlap{within.name, body.name, centre};
  }
  return std::nullopt;
}

} // namespace ndframe
