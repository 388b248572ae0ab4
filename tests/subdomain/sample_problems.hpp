#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/subdomain/unilateral_problem.hpp"

namespace ndframe::test
{

/// Reproducible numbers in (-1, 1).
Vector randomNumbers(int size, unsigned seed);

/// A full symmetric positive definite matrix, condition number some hundreds.
DenseMatrix randomSpd(int size, unsigned seed);

/// Springs between neighbours of a chain that nothing holds: null space (1).
DenseMatrix floatingChain(int size);
/// An elastic beam by second differences that nothing holds: null space (1, x), x = 0, 1, ...
DenseMatrix floatingBeam(int size);
/// The motions (1) or (1, x) at the nodes.
DenseMatrix rigidMotions(int size, int modes);
std::vector<std::string> motionNames(int modes);

/// A unilateral problem: see UnilateralProblem.
struct SampleProblem
{
  DenseMatrix A;
  Vector b, bound;
  std::vector<char> constrained;
  int modes = 0; ///< of the motions that nothing but contact holds

  int size() const { return A.rows(); }
  std::vector<char> allClosed() const { return constrained; }
};

/// Right-hand side, bounds and (for odd seeds) one unconstrained entry for a positive definite matrix.
SampleProblem randomProblem(int size, unsigned seed);

/// The solution found by trying every closed set; the test fails unless there is exactly one.
UnilateralState bruteForce(const SampleProblem& problem);

UnilateralState solve(const SampleProblem& problem, std::vector<char> closed);
UnilateralState solve(const SampleProblem& problem);

/// The largest violation of  A u = b + r,  u <= bound,  r <= 0,  (u - bound) r = 0,  relative to the largest force and
/// displacement.
double kktDefect(const SampleProblem& problem, const UnilateralState& state);

/// Same statuses, and displacements and forces equal to `tolerance` of the largest.
void expectSame(const UnilateralState& a, const UnilateralState& b, double tolerance = 1e-10);

/// Forwards to a stored matrix and notes the shifts of all inverses that were asked for.
class ShiftRecorder final : public SymmetricOperator
{
public:
  explicit ShiftRecorder(DenseMatrix A) : A_(makeDenseOperator(std::move(A))) {}
  int size() const override { return A_->size(); }
  Vector apply(const Vector& x) const override { return A_->apply(x); }
  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override
  {
    shifts.push_back(shift);
    return A_->inverseOn(isFree, shift);
  }
  const DenseMatrix* dense() const override { return A_->dense(); }

  mutable std::vector<double> shifts;

private:
  std::unique_ptr<SymmetricOperator> A_;
};

} // namespace ndframe::test
