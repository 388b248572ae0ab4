#pragma once

#include <string>
#include <vector>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/assembly/dof_layout.hpp"

namespace ndframe
{

/// Rigid motions about one centre: 2-D translation x, y and rotation; 3-D translations x, y, z and rotations about x,
/// y, z. Rotations are scaled by 1/length, so that all modes move the body by about 1.
struct RigidBasis
{
  int dim = 0;         ///< of space
  Direction centre{};  ///< about which rotations turn
  double length = 1.0; ///< distance from the centre at which rotations move by 1

  int size() const { return dim == 2 ? 3 : 6; } ///< number of modes
  /// Displacement of mode m at a point.
  Direction displacement(int mode, const double* point) const;
};

/// The basis at the centre of a body's bounding box, scaled with its diagonal.
RigidBasis rigidBasis(const Mesh& mesh);

/// The modes at all dofs, numDofs x modes, in the nodes' own axes (near null space of K).
DenseMatrix rigidModes(const RigidBasis& basis, const NodeMap& nodes, const Frames& frames);

/// Rows that rigid motions must annul to be held by supports: one row per prescribed direction, columns = modes.
DenseMatrix supportRows(const RigidBasis& basis, const NodeMap& nodes, const ConstraintSet& constraints);

/// Names of the motions spanned by the columns (orthonormal coefficients in the basis): "translation along x",
/// "translation along (0.8, 0.6)", "rotation about (0.5, 1)", "rotation about the axis (0, 0, 1)".
std::vector<std::string> describeMotions(const RigidBasis& basis, const DenseMatrix& motions);

/// One motion with its sense: "along +x", "along (0.8, -0.6)", "turning clockwise about (0.5, 1)", "turning about the
/// axis (0, 0, 1)" (right-handed; in space the translation of a screw is not told).
std::string describeMotion(const RigidBasis& basis, const Vector& motion);

/// Singular values below this, relative to the largest, are free motions.
inline constexpr double rigidTolerance = 1e-9;

} // namespace ndframe
