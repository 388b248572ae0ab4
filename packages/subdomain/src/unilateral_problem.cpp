#include "ndframe/subdomain/unilateral_problem.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double roundOff = 1e-11;      ///< signs and gaps below this, relative to the largest, are zero
constexpr double proximalDecay = 1e-1;  ///< weight of the proximal term, relative to the stiffness: 0.1, 0.01, ...
constexpr int largestProximalRun = 12;  ///< passes without enough contact after which the body counts as pulled off
constexpr double holdTolerance = 1e-12; ///< of the squared singular values of the closed nodes' rigid traces

std::string joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const auto& name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

int countDifferences(const std::vector<char>& a, const std::vector<char>& b)
{
  int n = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    n += a[i] != b[i];
  return n;
}

} // namespace

struct UnilateralProblem::Pass
{
  Vector u, force;
};

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

void UnilateralProblem::solveClosed(const Vector& b, const Vector& bound, const std::vector<char>& closed, double shift,
                                    Pass& pass)
{
  const auto n = std::size_t(A_.size());
  Vector given(n, 0.0);
  std::vector<char> isFree(n, 1);
  for (std::size_t i = 0; i < n; ++i)
    if (closed[i]) {
      given[i] = bound[i];
      isFree[i] = 0;
    }
  if (!factor_ || closed != factoredSet_ || shift != factoredShift_) {
    factor_.reset();
    factor_ = A_.inverseOn(isFree, shift);
    factoredSet_ = closed;
    factoredShift_ = shift;
    ledger_.count("interface factorisations");
  }
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
void UnilateralProblem::refine(const Vector& rhs, const std::vector<char>& isFree, Pass& pass) const
{
  Vector rest(rhs.size(), 0.0);
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (isFree[i])
      rest[i] = rhs[i] - pass.force[i];
  if (largestEntry(rest) <= roundOff * largestEntry(rhs))
    return;
  const Vector correction = factor_->solve(rest);
  for (std::size_t i = 0; i < rest.size(); ++i)
    pass.u[i] += correction[i];
  pass.force = applied(pass.u);
}

/// Nodes whose status contradicts the solution: closed ones under tension, open ones that penetrate. Where nothing is
/// closed, penetration has no tolerance: however weakly bodies touch, that they do is tried first.
std::vector<int> UnilateralProblem::violations(const Vector& b, const Vector& bound, const Pass& pass,
                                               const std::vector<char>& closed) const
{
  const double noForce = roundOff * std::max(largestEntry(pass.force), largestEntry(b));
  const bool isApart = std::none_of(closed.begin(), closed.end(), [](char status) { return status != 0; });
  const double noGap = isApart ? 0.0 : roundOff * std::max(largestEntry(pass.u), largestEntry(bound));
  std::vector<int> wrong;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (constrained_[i] && (closed[i] ? pass.force[i] > noForce : pass.u[i] - bound[i] > noGap))
      wrong.push_back(int(i));
  return wrong;
}

UnilateralState UnilateralProblem::solve(const Vector& b, const Vector& bound, std::vector<char> closed)
{
  const std::vector<char> start = closed;
  const int mostPasses = 100 + 10 * A_.size();
  UnilateralState state;
  Pass pass;
  std::set<std::vector<char>> seen;
  for (int proximal = 0; state.passes < mostPasses;) {
    const bool held = holds(closed);
    proximal = held ? 0 : proximal + 1;
    if (proximal > largestProximalRun)
      throw NotConverged(fmt::format("the load does not press the bodies together: contact opens and nothing stops {}",
                                     joined(motions_)));
    try {
      solveClosed(b, bound, closed, held ? 0.0 : std::pow(proximalDecay, proximal) * stiffnessScale(), pass);
    } catch (const NotPositiveDefinite&) {
      throw NotConverged(fmt::format("the closed nodes do not hold the bodies{}.",
                                     motions_.empty() ? "" : " against " + joined(motions_)));
    }
    ++state.passes;
    ledger_.count("status passes");
    const auto wrong = violations(b, bound, pass, closed);
    if (wrong.empty() && held) {
      state.changes = countDifferences(start, closed);
      ledger_.count("status changes", state.changes);
      state.u = std::move(pass.u);
      state.force = std::move(pass.force);
      state.closed = std::move(closed);
      return state;
    }
    state.cycled = state.cycled || (held && !seen.insert(closed).second);
    for (const int i : wrong) {
      closed[std::size_t(i)] = !closed[std::size_t(i)];
      if (state.cycled)
        break;
    }
  }
  throw NotConverged(fmt::format("the status method found no consistent set of closed nodes in {} passes{}.",
                                 mostPasses, state.cycled ? " (it cycled)" : ""));
}

} // namespace ndframe
