#pragma once

#include "ndframe/equilibrium/stress_correction.hpp"
#include "stress_blocks.hpp"
#include "stress_matrices.hpp"

namespace ndframe
{

/// Lowers the energy of equilibrated corrections by a few steps of conjugate gradients over all tractions that keep the
/// balance: what is in balance by itself on every face, and wrenches around every edge.
///
/// The energy is sum_E x_E^T A_E x_E, x_E = (T, G) the data of cell E. Matrices of the steps have single precision, the
/// tractions that are added double: whatever the steps are, cells stay in balance to round-off, and the energy falls.
class StressDescent
{
public:
  /// Finds all matrices: once for any number of corrections. body and faces must outlive it.
  StressDescent(const StarBody& body, const StressFaces& faces);
  StressDescent(const StressDescent&) = delete;
  StressDescent& operator=(const StressDescent&) = delete;

  /// Takes `steps` steps.
  void lower(StressCorrection& correction, int steps) const;

private:
  Vector gradientOf(const Vector& forces) const;
  Vector faceTractions(const Vector& unknowns) const;
  Vector forcesOf(const Vector& tractions) const;
  Vector startForces(const StressCorrection& correction) const;
  int numFaces() const { return int(faces_->faces().size()); }
  int facetData() const { return body_->facetData(); }

  const StarBody* body_;
  const StressFaces* faces_;
  StressBlocks blocks_;
  StressMatrices matrices_;
};

} // namespace ndframe
