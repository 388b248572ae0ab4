#include "ndframe/base/expression_enclosure.hpp"

#include "affine_range.hpp"
#include "curve_series.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "step_series.hpp"

namespace ndframe
{
namespace
{

constexpr double touching = 1e-13; ///< of an affine function's terms: what it may be beyond zero and still touch it

/// Goes through the operations once.
class Encloser
{
public:
  Encloser(const ExpressionTree& tree, const Region& region, int only, int order, DecidedSwitch decided)
      : tree_(tree), region_(&region), only_(only), count_(std::size_t(order) + 1), decided_(decided)
  {}
  /// Along a curve, for all t of an interval.
  Encloser(const ExpressionTree& tree, const Curve& curve, Interval t)
      : tree_(tree), curve_(&curve), t_(t), count_(Enclosure::order + 1)
  {}

  Series all();
  Enclosure whole();

private:
  Series seriesOf(int place);
  std::optional<AffineFunction> affineHere(const ExpressionNode& node) const;
  Series combined(const ExpressionNode& node);
  Series affine(const AffineFunction& f, bool varies) const;
  Series chosen(const ExpressionNode& node);
  Series extreme(const ExpressionNode& node);
  Series rounded(const ExpressionNode& node);
  const Series& operand(const ExpressionNode& node, std::size_t k) const
  {
    return series_[std::size_t(node.operands[k])];
  }
  /// The range of the k-th operand, its ends put to zero where they are round-off; remembers where it changes its sign.
  Interval signs(const ExpressionNode& node, std::size_t k);
  void cutAt(int place, double value);

  const ExpressionTree& tree_;
  const Region* region_ = nullptr;
  const Curve* curve_ = nullptr;
  Interval t_;
  int only_ = -1;
  std::size_t count_; ///< of the coefficients of series
  DecidedSwitch decided_;
  std::vector<Series> series_;
  /// The affine functions that operations are on this region, those that are so by a decided comparison among them.
  std::vector<std::optional<AffineFunction>> affine_;
  std::optional<AffineFunction> cut_;
  int curved_ = -1;
};

Series Encloser::affine(const AffineFunction& f, bool varies) const
{
  if (curve_)
    return affineAlong(f, *curve_, t_, count_);
  const AffineRange range(f, *region_);
  Series result;
  result.count = count_;
  result[0] = range.value;
  result[1] = range.slope;
  const double snap = touching * range.terms;
  if (result[0].lo < 0.0 && result[0].lo >= -snap && result[0].hi > snap)
    result[0].lo = 0.0;
  if (result[0].hi > 0.0 && result[0].hi <= snap && result[0].lo < -snap)
    result[0].hi = 0.0;
  if (varies)
    return result;
  const double middle = result[0].middle();
  return constant({middle, middle});
}

void Encloser::cutAt(int place, double value)
{
  const auto& f = affine_[std::size_t(place)];
  if (cut_ || !f)
    return;
  cut_ = f;
  (*cut_)[0] -= value;
}

Interval Encloser::signs(const ExpressionNode& node, std::size_t k)
{
  const auto& f = affine_[std::size_t(node.operands[k])];
  const Interval range = operand(node, k)[0];
  if (!(range.lo < 0.0 && range.hi > 0.0) || curve_)
    return range;
  if (node.operands[k] == decided_.place)
    return decided_.sign > 0.0 ? Interval{0.0, range.hi} : Interval{range.lo, 0.0};
  if (!f && curved_ < 0)
    curved_ = node.operands[k];
  if (f && range.hi - range.lo <= 2.0 * touching * AffineRange(*f, *region_).terms) {
    const auto value = valueAlong(*f, *region_); // a region along the line of zeros
    return value ? Interval{*value, *value} : range;
  }
  cutAt(node.operands[k], 0.0);
  return range;
}

Series Encloser::chosen(const ExpressionNode& node)
{
  const Interval condition = truth(operand(node, 0)[0]);
  if (condition.lo == condition.hi)
    return operand(node, condition.lo != 0.0 ? 1 : 2);
  return onlyRange(hull(operand(node, 1)[0], operand(node, 2)[0]));
}

/// min, max and abs = max(a, -a): kinks.
Series Encloser::extreme(const ExpressionNode& node)
{
  const bool isAbs = node.operation == Operation::Abs, isMaximum = isAbs || node.operation == Operation::Maximum;
  const Interval difference = signs(node, isAbs ? 0 : 2);
  const Series a = operand(node, 0), b = isAbs ? negative(a) : operand(node, 1);
  if (difference.lo >= 0.0 || difference.hi <= 0.0)
    return (difference.lo >= 0.0) == isMaximum ? a : b;
  const auto extremeOf = [isMaximum](double x, double y) { return isMaximum ? std::max(x, y) : std::min(x, y); };
  Interval range{extremeOf(a[0].lo, b[0].lo), extremeOf(a[0].hi, b[0].hi)};
  if (isAbs)
    range.lo = 0.0;
  return onlySlope(range, hull(a[1], b[1]));
}

/// rint, a step at every half number.
Series Encloser::rounded(const ExpressionNode& node)
{
  const Interval a = operand(node, 0)[0];
  if (!a.isBounded())
    return onlyRange(a);
  const double slack = touching * (1.0 + a.magnitude());
  const double low = std::floor(a.lo + 0.5 + slack), high = std::max(low, std::ceil(a.hi - 0.5 - slack));
  if (low < high)
    cutAt(node.operands[0], low + 0.5 + std::floor(0.5 * (high - low - 1.0)));
  return constantOn({low, high});
}

Series Encloser::combined(const ExpressionNode& node)
{
  switch (node.operation) {
  case Operation::Add:
    return sum(operand(node, 0), operand(node, 1));
  case Operation::Subtract:
    return sum(operand(node, 0), negative(operand(node, 1)));
  case Operation::Multiply:
    return node.operands[0] == node.operands[1] ? square(operand(node, 0))
                                                : product(operand(node, 0), operand(node, 1));
  case Operation::Divide:
    return quotient(operand(node, 0), operand(node, 1));
  case Operation::Negate:
    return negative(operand(node, 0));
  case Operation::Power: {
    const ExpressionNode& exponent = tree_.nodes()[std::size_t(node.operands[1])];
    if (exponent.operation == Operation::Constant)
      return power(operand(node, 0), exponent.constant);
    return exponential(product(operand(node, 1), logarithm(operand(node, 0))));
  }
  case Operation::Choose:
    return chosen(node);
  case Operation::Minimum:
  case Operation::Maximum:
  case Operation::Abs:
    return extreme(node);
  case Operation::Round:
    return rounded(node);
  case Operation::Exp:
    return exponential(operand(node, 0));
  case Operation::Log:
    return logarithm(operand(node, 0));
  case Operation::Sqrt:
    return power(operand(node, 0), 0.5);
  default:
    return elementary(node.operation, operand(node, 0));
  }
}

/// A decided choice is the function that it chooses.
std::optional<AffineFunction> Encloser::affineHere(const ExpressionNode& node) const
{
  const auto of = [&](std::size_t k) {
    return node.operands[k] < 0 ? std::nullopt : affine_[std::size_t(node.operands[k])];
  };
  const auto isDecided = [](Interval a) { return a.lo >= 0.0 || a.hi <= 0.0; };
  switch (node.operation) {
  case Operation::Choose: {
    const Interval condition = truth(operand(node, 0)[0]);
    return condition.lo == condition.hi ? of(condition.lo != 0.0 ? 1 : 2) : std::nullopt;
  }
  case Operation::Minimum:
  case Operation::Maximum: {
    const Interval difference = operand(node, 2)[0];
    const bool isFirst = (difference.lo >= 0.0) == (node.operation == Operation::Maximum);
    return isDecided(difference) ? of(isFirst ? 0 : 1) : std::nullopt;
  }
  case Operation::Abs: {
    const Interval a = operand(node, 0)[0];
    auto f = isDecided(a) ? of(0) : std::nullopt;
    for (std::size_t i = 0; f && a.lo < 0.0 && i < f->size(); ++i)
      (*f)[i] = -(*f)[i];
    return f;
  }
  default:
    return affineOf(node, of(0), of(1));
  }
}

Series Encloser::seriesOf(int place)
{
  const ExpressionNode& node = tree_.nodes()[std::size_t(place)];
  if (node.isAffine())
    return affine(node.affine, only_ < 0 || only_ == place);
  if (only_ < 0 && affine_.back())
    return affine(*affine_.back(), true);
  const auto both = [&](bool isAnd) {
    const Interval a = truth(operand(node, 0)[0]), b = truth(operand(node, 1)[0]);
    return isAnd ? Interval{a.lo * b.lo, a.hi * b.hi} : Interval{std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
  };
  if (node.operation >= Operation::IsNegative && node.operation <= Operation::IsNonZero)
    return constantOn(comparison(node.operation, signs(node, 0)));
  if (node.operation == Operation::And || node.operation == Operation::Or)
    return constantOn(both(node.operation == Operation::And));
  if (node.operation == Operation::Sign) {
    const Interval a = signs(node, 0);
    return constantOn(a.isZero() ? a : Interval{a.lo < 0.0 ? -1.0 : 1.0, a.hi > 0.0 ? 1.0 : -1.0});
  }
  if (node.operation == Operation::Atan2) {
    const Interval x = operand(node, 1)[0];
    return x.lo > 0.0 ? elementary(Operation::Atan, quotient(operand(node, 0), operand(node, 1)))
                      : onlyRange({-3.1415926535897936, 3.1415926535897936});
  }
  return combined(node);
}

Series Encloser::all()
{
  series_.reserve(tree_.nodes().size());
  for (std::size_t n = 0; n < tree_.nodes().size(); ++n) {
    const ExpressionNode& node = tree_.nodes()[n];
    affine_.push_back(node.isAffine() ? node.affine : affineHere(node));
    series_.push_back(seriesOf(int(n)));
  }
  return series_.back();
}

Enclosure Encloser::whole()
{
  Enclosure result;
  const Series series = all();
  result.range = series[0];
  result.slope = series[1];
  result.bend = count_ > 2 ? series[2] : Interval::everything();
  result.remainder[0] = series[0].radius();
  for (std::size_t n = 1; n < result.remainder.size(); ++n)
    result.remainder[n] = n < count_ ? series[n].magnitude() : std::numeric_limits<double>::infinity();
  result.cut = cut_;
  result.curved = curved_;
  return result;
}

} // namespace

double Enclosure::distance(int degree) const
{
  double least = remainder[0];
  for (int n = 1; n <= std::min(degree + 1, order); ++n)
    least = std::min(least, remainder[std::size_t(n)]);
  return least;
}

Enclosure enclose(const ExpressionTree& tree, const Region& region, int only, int order, DecidedSwitch decided)
{
  NDFRAME_ASSERT(order >= 1 && order <= Enclosure::longest, "no series is as long");
  return Encloser(tree, region, only, order, decided).whole();
}

double largestAlong(const ExpressionTree& tree, const Curve& curve)
{
  constexpr int parts = 4;
  constexpr double half = 1.0 / parts;
  double largest = 0.0;
  for (int part = 0; part < parts; ++part) {
    const double t = -1.0 + (2 * part + 1) * half;
    const Series middle = Encloser(tree, curve, {t, t}).all(), all = Encloser(tree, curve, {t - half, t + half}).all();
    double least = std::numeric_limits<double>::infinity(), known = 0.0, power = 1.0;
    for (std::size_t n = 0; n <= Enclosure::order; ++n, power *= half) {
      least = std::min(least, known + power * all[n].magnitude());
      known += power * middle[n].magnitude();
    }
    largest = std::max(largest, least);
  }
  return largest;
}

} // namespace ndframe
