#pragma once

#include "ndframe/drawing/drawn_scene.hpp"

namespace ndframe::test
{

/// A square of two triangles, with one named side: below (0), right (1), above (2) or left (3).
inline DrawnBody drawnSquare(const std::string& name, double x, double y, double size, const std::string& side,
                             int which)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {x, y, x + size, y, x + size, y + size, x, y + size};
  mesh.cells = {0, 1, 2, 0, 2, 3};
  const Facet facets[] = {{0, 2}, {0, 0}, {1, 0}, {1, 1}};
  mesh.sides = {{side, {facets[which]}}};
  return {name, false, mesh, {x + size / 2, y + size / 2, 0.0}, {{side, {}, {}, size}}};
}

/// A block of size 1, `gap` above a plate of size 2 and `right` of the middle of it.
inline DrawnAssembly blockOnPlate(double gap, double right = 0.0)
{
  return {2,
          4.0,
          {drawnSquare("plate", -1.0, -2.0, 2.0, "table", 2), drawnSquare("block", right - 0.5, gap, 1.0, "sole", 0)},
          {{0, 1, "table", "sole", gap}}};
}

} // namespace ndframe::test
