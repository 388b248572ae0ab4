#include <algorithm>
#include <utility>

#include "ndframe/algebra/neumann_solver.hpp"
#include "ndframe/interface/applied_operator.hpp"
#include "operators.hpp"

namespace ndframe
{
namespace
{

/// Entries hold a body if no motion is this much smaller there than elsewhere.
constexpr double leastHold = 1e-6;

Vector atEntries(const Vector& values, const std::vector<int>& entries)
{
  Vector result;
  for (const int i : entries)
    result.push_back(values[std::size_t(i)]);
  return result;
}

/// S_FF^-1 where the entries outside F hold the body's free motions R and no more: forces there make the load balance,
/// and a motion is added so that the Neumann solution vanishes there.
class NeumannInverse final : public RestrictedInverse
{
public:
  /// atHeld: R at the held entries, square.
  NeumannInverse(const NeumannSolver& body, std::vector<int> held, const DenseMatrix& atHeld)
      : body_(body), held_(std::move(held)), inverse_(pseudoInverse(atHeld, 0.0))
  {}

  Vector solve(const Vector& b) const override
  {
    const DenseMatrix& R = body_.freeMotions().traces;
    Vector force = b;
    for (const int i : held_)
      force[std::size_t(i)] = 0.0;
    const Vector reaction = multiplyTransposed(inverse_, multiplyTransposed(R, force));
    for (std::size_t k = 0; k < held_.size(); ++k)
      force[std::size_t(held_[k])] = -reaction[k];
    Vector u = body_.solveNeumann(force);
    const Vector motion = multiply(R, multiply(inverse_, atEntries(u, held_)));
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] -= motion[i];
    for (const int i : held_)
      u[std::size_t(i)] = 0.0;
    return u;
  }

private:
  const NeumannSolver& body_;
  std::vector<int> held_;
  DenseMatrix inverse_;
};

class MatrixFreeSchur final : public AppliedOperator
{
public:
  MatrixFreeSchur(const CondensedBody& body, int size, double tolerance)
      : AppliedOperator(tolerance), body_(body), neumann_(neumannSolver(body)), size_(size)
  {}
  int size() const override { return size_; }
  Vector apply(const Vector& x) const override { return body_.applySchur(x); }

  void forgetSolutions() const override
  {
    body_.forgetSolutions();
    heldStiffness_.clear(); // by such a solution
  }

  bool hasPreconditioner() const override { return neumann_.solvesNeumann(); }

  /// The Neumann solution, which knows nothing of the held entries, and there the inverse of S's diagonal.
  Vector precondition(const Vector& b) const override
  {
    if (!hasPreconditioner())
      return b;
    Vector u = neumann_.solveNeumann(b);
    const auto& held = neumann_.freeMotions().held;
    for (std::size_t k = 0; k < held.size(); ++k)
      u[std::size_t(held[k])] = b[std::size_t(held[k])] / heldStiffness()[k];
    return u;
  }

  std::unique_ptr<RestrictedInverse> directInverse(const std::vector<char>& isFree) const override
  {
    std::vector<int> held;
    for (std::size_t i = 0; i < isFree.size(); ++i)
      if (!isFree[i])
        held.push_back(int(i));
    const DenseMatrix& R = neumann_.freeMotions().traces;
    if (!neumann_.solvesNeumann() || int(held.size()) != R.cols())
      return nullptr;
    DenseMatrix atHeld(R.cols(), R.cols());
    for (int j = 0; j < R.cols(); ++j) {
      const Vector column = atEntries(R.column(j), held);
      std::copy(column.begin(), column.end(), atHeld.col(j));
    }
    if (R.cols() > 0 && nullSpace(atHeld, leastHold).cols() > 0)
      return nullptr;
    return std::make_unique<NeumannInverse>(neumann_, std::move(held), atHeld);
  }

private:
  const Vector& heldStiffness() const
  {
    for (std::size_t k = heldStiffness_.size(); k < neumann_.freeMotions().held.size(); ++k) {
      const auto held = std::size_t(neumann_.freeMotions().held[k]);
      Vector unit(std::size_t(size_), 0.0);
      unit[held] = 1.0;
      heldStiffness_.push_back(body_.applySchur(unit)[held]);
    }
    return heldStiffness_;
  }

  const CondensedBody& body_;
  const NeumannSolver& neumann_;
  int size_;
  mutable Vector heldStiffness_; ///< diagonal entries of S at the held entries, once they are needed
};

class MatrixFreeOperator final : public InterfaceOperator
{
public:
  explicit MatrixFreeOperator(double tolerance) : tolerance_(tolerance) {}
  std::unique_ptr<SymmetricOperator> represent(const CondensedBody& body, int size) const override
  {
    return makeMatrixFree(body, size, tolerance_);
  }

private:
  double tolerance_;
};

} // namespace

std::unique_ptr<SymmetricOperator> makeMatrixFree(const CondensedBody& body, int size, double tolerance)
{
  return std::make_unique<MatrixFreeSchur>(body, size, tolerance);
}

void registerMatrixFreeOperator(Registry<InterfaceOperator>& registry)
{
  registry.add("Matrix Free",
               "S applied from the body's factor or by one back substitution each time, inverted by one Neumann solve "
               "or by conjugate gradients preconditioned by Neumann solves: no n^2 memory.",
               {ParamSpec("Tolerance", interfaceTolerance, inOpenRange(0.0, 1.0),
                          "Relative residual of the conjugate gradients on the interface.")},
               [](const Params& p) { return std::make_unique<MatrixFreeOperator>(p.get<double>("Tolerance")); });
}

} // namespace ndframe
