#include "motion_balance.hpp"

#include <algorithm>
#include <utility>

namespace ndframe
{
MotionBalance::MotionBalance(const InterfaceSystem& system, DenseMatrix motions)
    : motions_(std::move(motions)), forces_(motions_.rows(), motions_.cols())
{
  for (int m = 0; m < motions_.cols(); ++m) {
    const UnknownValues force = system.forceOf(ofUnknowns(motions_.column(m)));
    std::copy(force.begin(), force.end(), forces_.col(m));
  }
  inverse_ = pseudoInverse(multiplyTransposed(motions_, forces_), rigidTolerance);
}

UnknownValues MotionBalance::corrected(UnknownValues force, Vector work) const
{
  if (motions_.cols() == 0)
    return force;
  const Vector present = multiplyTransposed(motions_, force);
  for (std::size_t m = 0; m < work.size(); ++m)
    work[m] -= present[m];
  const Vector correction = multiply(forces_, multiply(inverse_, work));
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] += correction[i];
  return force;
}

UnknownValues MotionBalance::balanced(UnknownValues force) const
{
  return corrected(std::move(force), Vector(std::size_t(motions_.cols()), 0.0));
}

} // namespace ndframe
