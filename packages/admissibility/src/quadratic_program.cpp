#include "ndframe/admissibility/quadratic_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double roundOff = 1e-13;
/// Sine of the angle below which a direction lies in the span of others.
constexpr double dependent = 1e-10;

/// y += factor x
void addTo(Vector& y, double factor, const Vector& x)
{
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += factor * x[i];
}

/// The span of the active normals, N = Q R with orthonormal Q.
class Span
{
public:
  struct Parts
  {
    Vector within; ///< coefficients in Q
    Vector rest;   ///< orthogonal to the span
  };

  Parts split(Vector a) const
  {
    Parts parts{Vector(Q_.size(), 0.0), std::move(a)};
    for (int pass = 0; pass < 2; ++pass) // twice is enough (Kahan; Parlett)
      for (std::size_t j = 0; j < Q_.size(); ++j) {
        const double along = dot(Q_[j], parts.rest);
        addTo(parts.rest, -along, Q_[j]);
        parts.within[j] += along;
      }
    return parts;
  }

  /// r with N r = Q within.
  Vector combination(Vector within) const
  {
    for (std::size_t j = within.size(); j-- > 0;) {
      for (std::size_t k = j + 1; k < within.size(); ++k)
        within[j] -= R_[k][j] * within[k];
      within[j] /= R_[j][j];
    }
    return within;
  }

  /// The point of the span with N^T y = b.
  Vector pointWith(const Vector& b) const
  {
    Vector y(Q_.empty() ? 0 : Q_[0].size(), 0.0), along;
    for (std::size_t j = 0; j < b.size(); ++j) {
      along.push_back(b[j]);
      for (std::size_t k = 0; k < j; ++k)
        along[j] -= R_[j][k] * along[k];
      along[j] /= R_[j][j];
      addTo(y, along[j], Q_[j]);
    }
    return y;
  }

  void append(Parts parts)
  {
    const double length = norm(parts.rest);
    for (double& value : parts.rest)
      value /= length;
    parts.within.push_back(length);
    Q_.push_back(std::move(parts.rest));
    R_.push_back(std::move(parts.within));
  }

private:
  std::vector<Vector> Q_, R_; ///< columns; column j of R has j + 1 entries
};

/// min 1/2 |y - start|^2 subject to a_i . y <= bound_i, all a_i of length 1 or 0.
class Projection
{
public:
  Projection(DenseMatrix normals, Vector bounds, Vector start)
      : normals_(std::move(normals)), bounds_(std::move(bounds)), start_(std::move(start)), y_(start_)
  {}

  /// False when the inequalities contradict each other.
  bool run()
  {
    const int limit = 100 * (normals_.rows() + normals_.cols() + 1);
    for (int step = 0; step < limit; ++step) {
      const int worst = mostViolated();
      if (worst < 0)
        return true;
      if (!activate(worst))
        return false;
    }
    NDFRAME_ASSERT(false, "the dual active set method is finite");
  }

  const Vector& point() const { return y_; }
  Vector multipliers() const
  {
    Vector all(bounds_.size(), 0.0);
    for (std::size_t j = 0; j < active_.size(); ++j)
      all[std::size_t(active_[j])] = multipliers_[j];
    return all;
  }

private:
  double violation(int i) const
  {
    double value = -bounds_[std::size_t(i)];
    for (std::size_t k = 0; k < y_.size(); ++k)
      value += normals_.col(i)[k] * y_[k];
    return value;
  }

  int mostViolated() const
  {
    const double reach = norm(y_);
    int worst = -1;
    double largest = 0.0;
    for (int i = 0; i < normals_.cols(); ++i) {
      const double value = violation(i) - roundOff * (reach + std::abs(bounds_[std::size_t(i)]));
      if (value > largest)
        largest = value, worst = i;
    }
    return worst;
  }

  /// Raises the multiplier of constraint p until it is met; others whose multipliers reach zero on the way leave.
  bool activate(int p)
  {
    for (;;) {
      Span::Parts parts = span_.split(normals_.column(p));
      const Vector r = span_.combination(parts.within);
      const double free = dot(parts.rest, parts.rest);
      const bool independent = free > dependent * dependent;
      const double full = independent ? violation(p) / free : infinity;
      const auto [partial, leaving] = firstToLeave(r);
      const double t = std::min(full, partial);
      if (t == infinity)
        return false;
      if (independent)
        addTo(y_, -t, parts.rest);
      addTo(multipliers_, -t, r);
      if (full <= partial) {
        span_.append(std::move(parts));
        active_.push_back(p);
        settle();
        return true;
      }
      remove(leaving);
    }
  }

  /// Point and multipliers anew from the active set, so that inequalities hold relative to the point itself however far
  /// away the start is.
  void settle()
  {
    Vector bounds;
    for (const int i : active_)
      bounds.push_back(bounds_[std::size_t(i)]);
    Span::Parts parts = span_.split(start_);
    const Vector within = span_.pointWith(bounds);
    const Vector held = span_.split(within).within;
    for (std::size_t j = 0; j < held.size(); ++j)
      parts.within[j] -= held[j];
    multipliers_ = span_.combination(std::move(parts.within));
    for (double& multiplier : multipliers_)
      multiplier = std::max(multiplier, 0.0); // but for round-off
    y_ = within;
    if (norm(parts.rest) > roundOff * norm(start_)) // else the span holds all of the start
      addTo(y_, 1.0, parts.rest);
  }

  std::pair<double, std::size_t> firstToLeave(const Vector& r) const
  {
    std::pair<double, std::size_t> first{infinity, 0};
    for (std::size_t j = 0; j < r.size(); ++j)
      if (r[j] > roundOff && multipliers_[j] / r[j] < first.first)
        first = {multipliers_[j] / r[j], j};
    return first;
  }

  void remove(std::size_t j)
  {
    active_.erase(active_.begin() + std::ptrdiff_t(j));
    multipliers_.erase(multipliers_.begin() + std::ptrdiff_t(j));
    span_ = Span();
    for (const int i : active_)
      span_.append(span_.split(normals_.column(i)));
  }

  DenseMatrix normals_;
  Vector bounds_, start_, y_;
  std::vector<int> active_;
  Vector multipliers_;
  Span span_;
};

} // namespace

std::optional<QuadraticMinimum> minimise(const QuadraticProgram& program)
{
  const int n = program.H.rows(), m = program.B.rows();
  NDFRAME_ASSERT(int(program.h.size()) == n && program.B.cols() == n && int(program.b.size()) == m,
                 "shapes do not match");
  const DenseCholesky factor(program.H);
  DenseMatrix normals(n, m);
  Vector bounds = program.b, lengths(std::size_t(m), 1.0);
  for (int i = 0; i < m; ++i) {
    Vector row(std::size_t(n), 0.0);
    for (int k = 0; k < n; ++k)
      row[std::size_t(k)] = program.B(i, k);
    row = factor.solveLower(std::move(row));
    double& length = lengths[std::size_t(i)];
    if (const double value = norm(row); value > 0.0)
      length = value;
    bounds[std::size_t(i)] /= length;
    for (int k = 0; k < n; ++k)
      normals(k, i) = row[std::size_t(k)] / length;
  }
  Vector start = factor.solveLower(program.h);
  for (double& value : start)
    value = -value;
  Projection projection(std::move(normals), std::move(bounds), std::move(start));
  if (!projection.run())
    return std::nullopt;
  QuadraticMinimum minimum{factor.solveUpper(projection.point()), projection.multipliers()};
  for (int i = 0; i < m; ++i)
    minimum.multipliers[std::size_t(i)] /= lengths[std::size_t(i)];
  return minimum;
}

} // namespace ndframe
