#include "switch_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

#include "line_polynomial.hpp"
#include "switch_frame.hpp"

namespace ndframe
{
namespace
{

/// Where f vanishes between two places with values of different signs, to round-off.
template <class Function>
double rootBetween(const Function& f, double low, double high, double atLow, double atHigh)
{
  std::uintmax_t evaluations = 60;
  const boost::math::tools::eps_tolerance<double> isRoundOff(52);
  const auto bracket = boost::math::tools::toms748_solve(f, low, high, atLow, atHigh, isRoundOff, evaluations);
  return 0.5 * (bracket.first + bracket.second);
}

} // namespace

/// Goes along the triangle and collects strips.
class SwitchCurve::Finder
{
public:
  /// firstPoint: the least distance of a rule's points from the ends, of the length.
  Finder(const ExpressionTree& s, const SwitchFrame& frame, double firstPoint, double allowed)
      : s_(s), frame_(frame), counted_(2.0 + 1.0 / firstPoint), allowed_(allowed)
  {}

  bool findAll();
  std::vector<Strip> strips;
  double open = 0.0; ///< area

private:
  struct Side
  {
    double xi[2], eta[2]; ///< its ends

    double at(double x) const { return eta[0] + (eta[1] - eta[0]) * (x - xi[0]) / (xi[1] - xi[0]); }
  };

  bool findBetween(const Side& lower, const Side& upper);
  void addRoots(const Side& side, std::vector<double>& places) const;
  bool addStrip(double from, double to, const Side& lower, const Side& upper);
  bool addCurve(Strip strip, const Side& lower, const Side& upper);
  LinePolynomial curve(const Strip& strip, const Side& lower, const Side& upper, int degree) const;
  double value(double xi, double eta) const { return frame_.value(s_, xi, eta); }
  double root(double xi, double low, double high) const;
  double areaWithin(double distance, const Strip& strip) const;
  bool count(double area);

  const ExpressionTree& s_;
  const SwitchFrame& frame_;
  double counted_; ///< times the area: by the integral, by the rule, and where the rule's points are as near
  double allowed_;
};

/// What counts where s may have the other sign within a distance along eta.
double SwitchCurve::Finder::areaWithin(double distance, const Strip& strip) const
{
  return 2.0 * strip.half * distance * counted_;
}

/// Counts it; false if that is too much.
bool SwitchCurve::Finder::count(double area)
{
  open += area;
  return open * frame_.density() <= allowed_;
}

/// Where s vanishes between two points over xi; the end of the range where it does not change its sign.
double SwitchCurve::Finder::root(double xi, double low, double high) const
{
  const double first = value(xi, low), last = value(xi, high);
  if (first >= 0.0)
    return low;
  return last <= 0.0 ? high : rootBetween([&](double eta) { return value(xi, eta); }, low, high, first, last);
}

/// Adds where s changes its sign along a side of the triangle, as far as some points show it: others make a strip that
/// is not shown to have one sign.
void SwitchCurve::Finder::addRoots(const Side& side, std::vector<double>& places) const
{
  constexpr int intervals = 8;
  const auto xiAt = [&](double share) { return side.xi[0] + share * (side.xi[1] - side.xi[0]); };
  const auto along = [&](double xi) { return value(xi, side.at(xi)); };
  double first = along(xiAt(0.0));
  for (int i = 0; i < intervals; ++i) {
    const double low = xiAt(double(i) / intervals), high = xiAt(double(i + 1) / intervals), last = along(high);
    if (first * last < 0.0)
      places.push_back(rootBetween(along, low, high, first, last));
    else if (last == 0.0)
      places.push_back(high);
    first = last;
  }
}

LinePolynomial SwitchCurve::Finder::curve(const Strip& strip, const Side& lower, const Side& upper, int degree) const
{
  std::vector<double> etas;
  for (int j = 0; j <= degree; ++j) {
    const double xi = strip.middle + strip.half * std::cos(M_PI * j / degree);
    etas.push_back(root(xi, lower.at(xi), upper.at(xi)));
  }
  return through(etas);
}

/// The polynomial of lowest degree that leaves hardly anything open, else the best.
bool SwitchCurve::Finder::addCurve(Strip strip, const Side& lower, const Side& upper)
{
  constexpr double enough = 0.01; // of what is allowed
  LinePolynomial best;
  double least = std::numeric_limits<double>::infinity();
  for (const int degree : {4, 8, 12}) {
    LinePolynomial eta = curve(strip, lower, upper, degree);
    const double distance = largestAlong(s_, frame_.curve(strip.middle, strip.half, eta)) / frame_.leastSlope();
    const double inside =
        std::min(leastCoefficient(differenceOf(eta, strip.lower)), leastCoefficient(differenceOf(strip.upper, eta)));
    const double area = areaWithin(distance + std::max(0.0, -inside), strip);
    if (area < least) {
      least = area;
      best = std::move(eta);
    }
    if (least * frame_.density() <= enough * allowed_)
      break;
  }
  if (!count(least))
    return false;
  Strip above = strip;
  strip.sign = -1.0, strip.upper = best;
  above.sign = 1.0, above.lower = std::move(best);
  strips.push_back(std::move(strip));
  strips.push_back(std::move(above));
  return true;
}

bool SwitchCurve::Finder::addStrip(double from, double to, const Side& lower, const Side& upper)
{
  const auto line = [&](const Side& side) {
    return LinePolynomial{0.5 * (side.at(from) + side.at(to)), 0.5 * (side.at(to) - side.at(from))};
  };
  Strip strip{0.5 * (from + to), 0.5 * (to - from), line(lower), line(upper), 0.0};
  const double least = value(strip.middle, strip.lower[0]), largest = value(strip.middle, strip.upper[0]);
  if (least < 0.0 && largest > 0.0)
    return addCurve(std::move(strip), lower, upper);
  strip.sign = least >= 0.0 ? 1.0 : -1.0;
  const Side& side = least >= 0.0 ? lower : upper;
  const double wrong = frame_.largest(s_, -strip.sign, {from, side.at(from)}, {to, side.at(to)});
  strips.push_back(strip);
  return count(areaWithin(std::max(0.0, wrong) / frame_.leastSlope(), strip));
}

bool SwitchCurve::Finder::findBetween(const Side& lower, const Side& upper)
{
  std::vector<double> places{lower.xi[0], lower.xi[1]};
  addRoots(lower, places);
  addRoots(upper, places);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (places[i] < places[i + 1] && !addStrip(places[i], places[i + 1], lower, upper))
      return false;
  return true;
}

/// The triangle is cut at the corner in the middle.
bool SwitchCurve::Finder::findAll()
{
  auto corners = frame_.corners();
  std::sort(corners.begin(), corners.end());
  const auto& [a, b, c] = corners;
  const Side whole{{a[0], c[0]}, {a[1], c[1]}};
  const bool isBelow = b[1] < whole.at(b[0]);
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c)}) {
    if (from[0] == to[0])
      continue;
    const Side part{{from[0], to[0]}, {from[1], to[1]}};
    const Side other{{from[0], to[0]}, {whole.at(from[0]), whole.at(to[0])}};
    if (!findBetween(isBelow ? part : other, isBelow ? other : part))
      return false;
  }
  return true;
}

std::optional<SwitchCurve> SwitchCurve::find(const ExpressionTree& s, const SimplexGeometry& simplex,
                                             const Samples::Piece& triangle, int degree, double allowed)
{
  const auto frame = SwitchFrame::on(s, simplex, triangle);
  if (!frame)
    return {};
  SwitchCurve curve;
  curve.degree_ = degree;
  curve.across_ = simplexRule(1, std::max(degree, 3));
  const auto& lambda = curve.across_.lambda;
  Finder finder(s, *frame, *std::min_element(lambda.begin(), lambda.end()), allowed);
  if (!finder.findAll())
    return {};
  curve.strips_ = std::move(finder.strips);
  curve.density_ = frame->density();
  curve.open_ = finder.open * curve.density_;
  frame->barycentric(simplex, triangle, curve.origin_, curve.alongXi_, curve.alongEta_);
  return curve;
}

/// Gauss points along xi, and over each of them between the two polynomials.
void SwitchCurve::addPoints(const Strip& strip, QuadratureRule& rule) const
{
  const int bend = int(std::max(strip.lower.size(), strip.upper.size())) - 1;
  const QuadratureRule along = simplexRule(1, std::max((degree_ + 1) * bend, 3));
  for (int i = 0; i < along.size(); ++i) {
    const double t = along.point(i)[1] - along.point(i)[0], xi = strip.middle + t * strip.half;
    const double low = valueAt(strip.lower, t), height = valueAt(strip.upper, t) - low;
    const double weight = 2.0 * strip.half * along.weights[std::size_t(i)] * height * density_;
    for (int j = 0; j < across_.size(); ++j) {
      const double eta = low + across_.point(j)[1] * height;
      for (std::size_t k = 0; k < 3; ++k)
        rule.lambda.push_back(origin_[k] + xi * alongXi_[k] + eta * alongEta_[k]);
      rule.weights.push_back(weight * across_.weights[std::size_t(j)]);
    }
  }
}

QuadratureRule SwitchCurve::side(double sign) const
{
  QuadratureRule rule{2, {}, {}};
  for (const auto& strip : strips_)
    if (strip.sign == sign)
      addPoints(strip, rule);
  return rule;
}

} // namespace ndframe
