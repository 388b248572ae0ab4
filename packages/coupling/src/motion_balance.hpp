#pragma once

#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{

/// The work R^T r that contact forces r do on free motions with traces R, and how to correct it: by the forces C R a,
/// those of the smallest traction (in L2 on the interface) with that work. Motions that depend on each other on the
/// interface are met in the least-squares sense.
class MotionBalance
{
public:
  /// motions: R, unknowns x motions; it may have no columns.
  MotionBalance(const InterfaceSystem& system, DenseMatrix motions);

  /// force + C R a with R^T (force + C R a) = work.
  UnknownValues corrected(UnknownValues force, Vector work) const;
  /// The force without work on the motions.
  UnknownValues balanced(UnknownValues force) const;

private:
  DenseMatrix motions_, forces_; ///< R, C R
  DenseMatrix inverse_;          ///< (R^T C R)^-1
};

} // namespace ndframe
