#pragma once

#include <array>
#include <string>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Zero beyond the dimension of the scene.
using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b); ///< sum a_k b_k

/// A named side as it is drawn.
struct DrawnSide
{
  std::string name; ///< of its physical group
  /// Centroid of the side.
  Vector3 centre, normal; ///< mean outward normal: of length 1 where the side is flat
  double measure;         ///< length or area
  /// In a contact of the scene.
  bool touches = false, isSymmetry = false; ///< guessed: flat, touches nothing, and other bodies have one like it

  bool isFlat() const { return dot(normal, normal) > 1.0 - 1e-9; } ///< one normal on all facets
  bool isFree() const { return !touches && !isSymmetry; }          ///< may be held, moved or loaded
};

/// A body as it is drawn: a physical group of cells of gmsh.
struct DrawnBody
{
  std::string name;             ///< of its physical group; "body" for a whole file
  bool isWholeFile;             ///< the file has no physical group of cells
  Mesh mesh;                    ///< as a deck reads it
  Vector3 centre;               ///< centroid of the cells
  std::vector<DrawnSide> sides; ///< those with a name
};

/// Sides of two bodies that may touch, and how far apart they begin (a length).
struct DrawnContact
{
  /// Place of the first body in DrawnAssembly::bodies.
  std::size_t first, second; ///< place of the second body
  /// Name of the first body's side.
  std::string firstSide, secondSide; ///< name of the second body's side
  double opening;                    ///< the smallest; 0: they touch or overlap
};

/// Everything that a drawing says.
struct DrawnAssembly
{
  int dim;                            ///< of space, 2 or 3
  double extent;                      ///< diagonal of the box around all bodies
  std::vector<DrawnBody> bodies;      ///< at least one
  std::vector<DrawnContact> contacts; ///< only one body may have none
};

} // namespace ndframe
