#pragma once

#include <array>
#include <string>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Zero beyond the dimension of the scene.
using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b);

/// A named side as it is drawn.
struct DrawnSide
{
  std::string name;
  Vector3 centre, normal; ///< mean outward normal: of length 1 where the side is flat
  double measure;
  bool touches = false, isSymmetry = false;

  bool isFlat() const { return dot(normal, normal) > 1.0 - 1e-9; }
  bool isFree() const { return !touches && !isSymmetry; }
};

/// A body as it is drawn: a physical group of cells of gmsh.
struct DrawnBody
{
  std::string name;
  bool isWholeFile; ///< the file has no physical group of cells
  Mesh mesh;
  Vector3 centre;
  std::vector<DrawnSide> sides;
};

/// Sides of two bodies that may touch, and how far apart they begin (a length).
struct DrawnContact
{
  std::size_t first, second;
  std::string firstSide, secondSide;
  double opening;
};

/// Everything that a drawing says.
struct DrawnScene
{
  int dim;
  double extent; ///< diagonal of the box around all bodies
  std::vector<DrawnBody> bodies;
  std::vector<DrawnContact> contacts;
};

} // namespace ndframe
