#include "banded_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Signs are judged and conditions met to this, relative to the largest entry.
constexpr double roundOff = 1e-13;
/// The proximal term against the response of the conditions.
constexpr double proximal = 1e-10;
constexpr int maxProximalSteps = 100;
/// Steps of full exchange that may fail to reduce the number of wrong signs.
constexpr int patience = 3;

class BlockPivoting
{
public:
  explicit BlockPivoting(const BandedProgram& program)
      : program_(program), fixed_(program.f.size(), 0), multipliers_(program.r.size(), 0.0)
  {
    double response = 0.0;
    for (int k = 0; k < program.W.cols(); ++k) {
      double sum = 0.0;
      for (int i = 0; i < program.M.size(); ++i)
        sum += program.W(i, k) * program.W(i, k) / program.M(i, i);
      response = std::max(response, sum);
    }
    shift_ = proximal * response;
  }

  Vector run()
  {
    for (int step = 0; step < maxProximalSteps; ++step) {
      const Vector old = multipliers_;
      pivot(old);
      if (conditionsMet(old)) {
        for (double& value : x_)
          value = std::min(value, 0.0);
        return x_;
      }
    }
    NDFRAME_ASSERT(false, "the proximal steps end for a program that has admissible points");
  }

private:
  void pivot(const Vector& oldMultipliers)
  {
    std::size_t fewest = fixed_.size() + 1;
    int tries = patience;
    for (;;) {
      solve(oldMultipliers);
      const std::vector<std::size_t> wrong = wrongSigns();
      if (wrong.empty())
        return;
      const bool fewer = wrong.size() < fewest;
      tries = fewer ? patience : tries - 1;
      fewest = std::min(fewest, wrong.size());
      for (std::size_t i = tries >= 0 ? 0 : wrong.size() - 1; i < wrong.size(); ++i)
        fixed_[wrong[i]] = !fixed_[wrong[i]];
    }
  }

  /// x and the multipliers for the entries that are fixed now: [M W; W^T -e] (x, lambda) = (f, r - e lambda_old).
  void solve(const Vector& oldMultipliers)
  {
    const BandCholesky factor(freePart());
    x_ = factor.solve(freePart(program_.f));
    const int conditions = program_.W.cols();
    if (conditions == 0 || shift_ == 0.0)
      return;
    DenseMatrix response(conditions, conditions), moved(program_.M.size(), conditions);
    Vector gap(std::size_t(conditions), 0.0);
    for (int k = 0; k < conditions; ++k) {
      const Vector column = factor.solve(freePart(program_.W.column(k)));
      std::copy(column.begin(), column.end(), moved.col(k));
    }
    response = multiplyTransposed(program_.W, moved);
    const Vector work = multiplyTransposed(program_.W, DenseMatrix(x_)).column(0);
    for (int k = 0; k < conditions; ++k) {
      const auto at = std::size_t(k);
      response(k, k) += shift_;
      gap[at] = work[at] - program_.r[at] + shift_ * oldMultipliers[at];
    }
    multipliers_ = DenseCholesky(std::move(response)).solve(std::move(gap));
    const Vector change = multiply(moved, multipliers_);
    for (std::size_t i = 0; i < x_.size(); ++i)
      x_[i] -= change[i];
  }

  /// M with the rows and columns of fixed entries those of a diagonal matrix.
  BandMatrix freePart() const
  {
    BandMatrix M = program_.M;
    const int n = M.size(), bandwidth = M.bandwidth();
    for (int i = 0; i < n; ++i)
      if (fixed_[std::size_t(i)])
        for (int j = std::max(0, i - bandwidth); j < std::min(n, i + bandwidth + 1); ++j)
          if (j != i)
            M(i, j) = 0.0;
    return M;
  }

  Vector freePart(Vector v) const
  {
    for (std::size_t i = 0; i < v.size(); ++i)
      if (fixed_[i])
        v[i] = 0.0;
    return v;
  }

  /// Free entries above their bound, fixed entries that are held back (f - M x - W lambda < 0).
  std::vector<std::size_t> wrongSigns() const
  {
    Vector pull = program_.f;
    const Vector stress = multiply(program_.M, x_), held = multiply(program_.W, multipliers_);
    double scale = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double diagonal = program_.M(int(i), int(i));
      scale = std::max({scale, std::abs(x_[i]), std::abs(pull[i]) / diagonal, std::abs(held[i]) / diagonal});
      pull[i] -= stress[i] + held[i];
    }
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < x_.size(); ++i)
      if (fixed_[i] ? pull[i] < -roundOff * scale * program_.M(int(i), int(i)) : x_[i] > roundOff * scale)
        wrong.push_back(i);
    return wrong;
  }

  /// W^T x - r = e (lambda - lambda_old) is round-off of its terms.
  bool conditionsMet(const Vector& oldMultipliers) const
  {
    for (int k = 0; k < program_.W.cols(); ++k) {
      const auto at = std::size_t(k);
      double terms = std::abs(program_.r[at]);
      for (std::size_t i = 0; i < x_.size(); ++i)
        terms += std::abs(program_.W(int(i), k) * x_[i]);
      if (shift_ * std::abs(multipliers_[at] - oldMultipliers[at]) > roundOff * terms)
        return false;
    }
    return true;
  }

  const BandedProgram& program_;
  std::vector<char> fixed_; ///< per entry: 1 = at its bound
  Vector multipliers_, x_;
  double shift_ = 0.0;
};

} // namespace

Vector minimise(const BandedProgram& program)
{
  const std::size_t n = program.f.size();
  NDFRAME_ASSERT(std::size_t(program.M.size()) == n && std::size_t(program.W.cols()) == program.r.size() &&
                     (program.r.empty() || std::size_t(program.W.rows()) == n),
                 "shapes do not match");
  return BlockPivoting(program).run();
}

} // namespace ndframe
