#pragma once

#include <functional>
#include <string>
#include <vector>

#include "certificate/draw.hpp"
#include "certificate/frame.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe::test
{

/// A rectangle of the unit frame, cut along grid lines; sides left, right, bottom, top, and the parts of one of them.
struct Rectangle
{
  std::vector<double> x, y; ///< grid lines, increasing
  std::string split;        ///< the side that is cut at x = `at` into first and second; empty: none
  double at = 0.0;
  std::string first, second;
};

/// Equal cells.
std::vector<double> gridLines(double from, double to, int cells);

/// Inner lines moved by up to a third of a cell.
std::vector<double> shaken(std::vector<double> lines, Draw& draw);

/// Triangles with random diagonals, inner vertices moved by up to `jitter` of a cell, then lifted by `lift(x)` (a
/// kinked interface), then put into space.
Mesh randomMesh(const Rectangle& rectangle, double jitter, const std::function<double(double)>& lift,
                const Frame& frame, Draw& draw);

} // namespace ndframe::test
