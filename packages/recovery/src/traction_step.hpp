#pragma once

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe
{

/// One end of a patch of the plane, by its vertex (0, 1).
struct PatchEnd
{
  int patch, vertex;
};

/// How the traction at one interface vertex should change:
///
///   min 1/2 dt^T H dt + h^T dt   subject to  E dt = 0,  signConditions() of t + dt <= 0 on each patch,
///
/// dt: patch by patch, mode by mode, along n_c, moments (forces). H is positive definite where E dt = 0.
class TractionStep
{
public:
  /// E: balance of both bodies' stars, numbers of the order of 1; rows may vanish or depend on each other.
  TractionStep(std::vector<PatchEnd> ends, const DenseMatrix& E, DenseMatrix H, Vector h);

  /// Makes the step from the given traction, which must be admissible, in place; it goes into the shares of this
  /// vertex. Returns dt. The objective falls or dt = 0. Another call goes on from there, with h the gradient there.
  Vector apply(ContactTraction& traction);

private:
  /// signConditions() on the patches times their measures.
  Vector coefficients(const ContactTraction& traction) const;

  std::vector<PatchEnd> ends_;
  DenseMatrix H_, basis_, reducedH_, conditions_, reducedB_;
  Vector h_;
};

} // namespace ndframe
