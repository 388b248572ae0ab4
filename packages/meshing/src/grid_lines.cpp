#include "grid_lines.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

namespace
{

/// The map x <-> xi of a profile, with knots where h has kinks and at the breaks.
class Equidistribution
{
public:
  Equidistribution(double lower, double upper, const SizeProfile& profile, const std::vector<double>& breaks)
  {
    x_ = {lower, upper};
    x_.insert(x_.end(), breaks.begin(), breaks.end());
    std::copy_if(profile.at.begin(), profile.at.end(), std::back_inserter(x_),
                 [&](double at) { return lower < at && at < upper; });
    std::sort(x_.begin(), x_.end());
    x_.erase(std::unique(x_.begin(), x_.end()), x_.end());
    for (const double x : x_)
      size_.push_back(sizeAt(profile, x));
    xi_ = {0.0};
    for (std::size_t i = 0; i + 1 < x_.size(); ++i)
      xi_.push_back(xi_[i] +
                    (x_[i + 1] - x_[i]) / size_[i] * (slope(i) == 0.0 ? 1.0 : std::log1p(slope(i)) / slope(i)));
  }

  /// xi at a knot.
  double xiAtKnot(double x) const { return xi_[std::lower_bound(x_.begin(), x_.end(), x) - x_.begin()]; }
  double total() const { return xi_.back(); }

  double x(double xi) const
  {
    const auto after = std::upper_bound(xi_.begin() + 1, xi_.end() - 1, xi);
    const std::size_t i = std::size_t(after - xi_.begin()) - 1;
    const double t = (xi - xi_[i]) / (xi_[i + 1] - xi_[i]);
    const double fraction = slope(i) == 0.0 ? t : std::expm1(t * std::log1p(slope(i))) / slope(i);
    return x_[i] + (x_[i + 1] - x_[i]) * fraction;
  }

private:
  /// Relative growth of h over interval i.
  double slope(std::size_t i) const { return size_[i + 1] / size_[i] - 1.0; }

  static double sizeAt(const SizeProfile& profile, double x)
  {
    const auto after = std::upper_bound(profile.at.begin(), profile.at.end(), x);
    if (after == profile.at.begin())
      return profile.size.front();
    if (after == profile.at.end())
      return profile.size.back();
    const std::size_t i = std::size_t(after - profile.at.begin());
    const double t = (x - profile.at[i - 1]) / (profile.at[i] - profile.at[i - 1]);
    return profile.size[i - 1] + t * (profile.size[i] - profile.size[i - 1]);
  }

  std::vector<double> x_;
  std::vector<double> size_;
  std::vector<double> xi_;
};

} // namespace

SizeProfile geometricProfile(double lower, double upper, int cells, double ratio)
{
  // n cells in geometric sequence of factor q have last / first = q^(n-1), while h grows by q^n over all of them.
  const double growth = cells > 1 ? std::pow(ratio, double(cells) / (cells - 1)) : 1.0;
  return {{lower, upper}, {1.0, growth}};
}

std::vector<double> gridLines(double lower, double upper, int cells, const SizeProfile& profile,
                              const std::vector<double>& breaks)
{
  const Equidistribution map(lower, upper, profile, breaks);
  std::vector<double> lines{lower};
  double from = 0.0;
  const int pieces = int(breaks.size()) + 1;
  for (int piece = 0; piece < pieces; ++piece) {
    const double end = piece + 1 < pieces ? breaks[piece] : upper;
    const double to = piece + 1 < pieces ? map.xiAtKnot(end) : map.total();
    const int done = int(lines.size()) - 1;
    const int wanted = int(std::lround(to / map.total() * cells)) - done;
    const int count = std::clamp(wanted, 1, cells - done - (pieces - piece - 1));
    for (int k = 1; k < count; ++k)
      lines.push_back(map.x(from + (to - from) * k / count));
    lines.push_back(end);
    from = to;
  }
  return lines;
}

} // namespace ndframe
