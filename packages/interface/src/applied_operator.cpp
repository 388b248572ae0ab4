#include "ndframe/interface/applied_operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// A search direction with less stiffness than this, relative to the stiffest one, is in the null space.
constexpr double noStiffness = 1e-13;

class ConjugateGradients final : public RestrictedInverse
{
public:
  ConjugateGradients(const AppliedOperator& A, std::vector<char> isFree, double shift)
      : A_(A), isFree_(std::move(isFree)), shift_(shift)
  {}

  Vector solve(const Vector& b) const override
  {
    const int mostIterations = 200 + 10 * A_.size();
    Vector x(b.size(), 0.0), r = restricted(b);
    double rr = dot(r, r), stiffest = 0.0;
    if (rr == 0.0)
      return x;
    Vector p = restricted(A_.precondition(r));
    double rz = dot(r, p);
    const double target = A_.tolerance() * A_.tolerance() * rr;
    for (int iteration = 0; rr > target; ++iteration) {
      if (iteration == mostIterations)
        throw NotConverged(
            fmt::format("conjugate gradients on the interface stopped at a relative residual of {:.1e} after "
                        "{} iterations; use the condensed interface operator.",
                        std::sqrt(rr / target) * A_.tolerance(), iteration));
      const Vector Ap = applyRestricted(p);
      const double curvature = dot(p, Ap), stiffness = curvature / dot(p, p);
      stiffest = std::max(stiffest, stiffness);
      if (!(stiffness > noStiffness * stiffest))
        throw NotPositiveDefinite{-1};
      const double step = rz / curvature;
      for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += step * p[i];
        r[i] -= step * Ap[i];
      }
      const Vector z = restricted(A_.precondition(r));
      const double next = dot(r, z);
      for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = z[i] + next / rz * p[i];
      rz = next;
      rr = dot(r, r);
    }
    return x;
  }

private:
  Vector restricted(Vector v) const
  {
    for (std::size_t i = 0; i < v.size(); ++i)
      if (!isFree_[i])
        v[i] = 0.0;
    return v;
  }
  Vector applyRestricted(const Vector& p) const
  {
    Vector Ap = A_.apply(p);
    for (std::size_t i = 0; i < p.size(); ++i)
      Ap[i] += shift_ * p[i];
    return restricted(std::move(Ap));
  }

  const AppliedOperator& A_;
  std::vector<char> isFree_;
  double shift_;
};

} // namespace

std::unique_ptr<RestrictedInverse> AppliedOperator::inverseOn(const std::vector<char>& isFree, double shift) const
{
  if (shift == 0.0)
    if (auto direct = directInverse(isFree))
      return direct;
  return std::make_unique<ConjugateGradients>(*this, isFree, shift);
}

const AppliedOperator* asApplied(const SymmetricOperator& S)
{
  if (S.dense() != nullptr)
    return nullptr;
  const auto* applied = dynamic_cast<const AppliedOperator*>(&S);
  NDFRAME_ASSERT(applied != nullptr, "an interface operator is neither stored nor an AppliedOperator");
  return applied;
}

double toleranceOf(const SymmetricOperator& S)
{
  const AppliedOperator* applied = asApplied(S);
  return applied == nullptr ? 0.0 : applied->tolerance();
}

} // namespace ndframe
