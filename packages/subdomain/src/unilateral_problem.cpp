#include "ndframe/subdomain/unilateral_problem.hpp"

#include <algorithm>
#include <utility>

namespace ndframe
{
namespace
{

constexpr double holdTolerance = 1e-12; ///< of the squared singular values of the closed nodes' rigid traces

} // namespace

UnilateralProblem::UnilateralProblem(const SymmetricOperator& A, std::vector<char> constrained, DenseMatrix rigidTraces,
                                     std::vector<std::string> motions, Ledger& ledger)
    : A_(A), constrained_(std::move(constrained)), rigidTraces_(std::move(rigidTraces)), motions_(std::move(motions)),
      ledger_(ledger)
{}

bool UnilateralProblem::holds(const std::vector<char>& closed) const
{
  if (rigidTraces_.cols() == 0)
    return true;
  DenseMatrix gram(rigidTraces_.cols(), rigidTraces_.cols());
  for (int i = 0; i < rigidTraces_.rows(); ++i)
    if (closed[std::size_t(i)])
      for (int a = 0; a < gram.rows(); ++a)
        for (int c = 0; c < gram.cols(); ++c)
          gram(a, c) += rigidTraces_(i, a) * rigidTraces_(i, c);
  return nullSpace(gram, holdTolerance).cols() == 0;
}

double UnilateralProblem::stiffnessScale() const
{
  Vector zigzag(std::size_t(A_.size()));
  for (std::size_t i = 0; i < zigzag.size(); ++i)
    zigzag[i] = i % 2 == 0 ? 1.0 : -1.0;
  const double scale = dot(zigzag, A_.apply(zigzag)) / dot(zigzag, zigzag);
  return scale > 0.0 ? scale : 1.0; // A = 0, a body that can only move rigidly: any weight will do
}

/// A x. Contact that is closed or open everywhere leaves one of the two parts of u zero, and a product is what a pass
/// costs.
Vector UnilateralProblem::applied(const Vector& x) const
{
  const bool isZero = std::all_of(x.begin(), x.end(), [](double value) { return value == 0.0; });
  if (isZero)
    return x;
  ledger_.count("interface products");
  return A_.apply(x);
}

void UnilateralProblem::factor(const std::vector<char>& closed, const std::vector<char>& isFree, double shift)
{
  if (factor_ && closed == factoredSet_ && shift == factoredShift_)
    return;
  if (factor_ && shift == factoredShift_ && factor_->moveTo(isFree)) {
    ledger_.count("interface factors moved");
  } else {
    factor_.reset(); // its memory is needed
    factor_ = A_.inverseOn(isFree, shift);
    ledger_.count("interface factorisations");
  }
  factoredSet_ = closed;
  factoredShift_ = shift;
}

void UnilateralProblem::solveClosed(const Vector& b, const Vector& bound, const std::vector<char>& closed, double shift,
                                    StatusPass& pass)
{
  const auto n = std::size_t(A_.size());
  Vector given(n, 0.0);
  std::vector<char> isFree(n, 1);
  for (std::size_t i = 0; i < n; ++i)
    if (closed[i]) {
      given[i] = bound[i];
      isFree[i] = 0;
    }
  factor(closed, isFree, shift);
  const Vector fromGiven = applied(given);
  Vector rhs(n);
  for (std::size_t i = 0; i < n; ++i)
    rhs[i] = b[i] - fromGiven[i] + shift * (pass.u.empty() ? 0.0 : pass.u[i]);
  pass.u = factor_->solve(rhs);
  pass.force = applied(pass.u);
  if (A_.dense() && shift == 0.0)
    refine(rhs, isFree, pass);
  for (std::size_t i = 0; i < n; ++i) {
    pass.u[i] += given[i];
    pass.force[i] = closed[i] ? fromGiven[i] + pass.force[i] - b[i] : 0.0;
  }
}

/// One step of iterative refinement where the factor loses more digits than signs may cost: stiff beside soft bodies.
void UnilateralProblem::refine(const Vector& rhs, const std::vector<char>& isFree, StatusPass& pass) const
{
  Vector rest(rhs.size(), 0.0);
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (isFree[i])
      rest[i] = rhs[i] - pass.force[i];
  if (largestEntry(rest) <= statusRoundOff * largestEntry(rhs))
    return;
  const Vector correction = factor_->solve(rest);
  for (std::size_t i = 0; i < rest.size(); ++i)
    pass.u[i] += correction[i];
  pass.force = applied(pass.u);
}

/// The problem with one load and one bound.
class UnilateralProblem::Conditions final : public StatusSystem
{
public:
  Conditions(UnilateralProblem& problem, const Vector& b, const Vector& bound)
      : problem_(problem), b_(b), bound_(bound), load_(largestEntry(b))
  {}

  bool holds(const std::vector<char>& closed) override { return problem_.holds(closed); }
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override
  {
    problem_.solveClosed(b_, bound_, closed, proximal == 0.0 ? 0.0 : proximal * problem_.stiffnessScale(), pass);
    pass.displacement = largestEntry(pass.u);
    pass.load = load_;
  }
  const std::vector<std::string>& motions() const override { return problem_.motions_; }
  StatusMemory memory() override
  {
    problem_.forgetFactor();
    problem_.A_.forgetSolutions();
    return {};
  }
  bool recall(const StatusMemory& of) override
  {
    memory();
    return of.fields.empty() && of.displacement.empty();
  }

private:
  UnilateralProblem& problem_;
  const Vector &b_, &bound_;
  double load_;
};

UnilateralState UnilateralProblem::solve(const Vector& b, const Vector& bound, std::vector<char> closed,
                                         const PassesKept& kept)
{
  Conditions conditions(*this, b, bound);
  return findStatuses(conditions, constrained_, bound, std::move(closed), ledger_, kept);
}

} // namespace ndframe
