#include <cmath>
#include <limits>

#include "affine_range.hpp"

namespace ndframe
{
namespace
{

double termSum(const AffineFunction& f, const Region::Point& x)
{
  return std::abs(f[0]) + std::abs(f[1] * x[0]) + std::abs(f[2] * x[1]) + std::abs(f[3] * x[2]);
}

double linearPart(const AffineFunction& f, const Region::Point& x)
{
  return f[1] * x[0] + f[2] * x[1] + f[3] * x[2];
}

} // namespace

AffineRange::AffineRange(const AffineFunction& f, const Region& region)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  value = slope = {infinity, -infinity};
  for (const auto& x : region.points) {
    const double v = f[0] + linearPart(f, x);
    value = hull(value, {v, v});
    terms = std::max(termSum(f, x), terms); // keeps a NaN
  }
  for (const auto& d : region.directions) {
    const double v = linearPart(f, d);
    slope = hull(slope, {v, v});
  }
  if (!std::isfinite(terms)) { // a constant that is not defined, as sqrt(-1)
    value = slope = Interval::everything();
    return;
  }
  const double rounding = 4.0 * 0x1p-52 * terms;
  value = {value.lo - rounding, value.hi + rounding};
  if (f[1] != 0.0 || f[2] != 0.0 || f[3] != 0.0)
    slope = {slope.lo - rounding, slope.hi + rounding};
  else
    slope = {};
}

std::optional<double> valueAlong(const AffineFunction& f, const Region& region)
{
  const Region::Point& first = region.points.front();
  for (const auto& x : region.points)
    for (std::size_t k = 0; k < 3; ++k)
      if (f[k + 1] != 0.0 && x[k] != first[k])
        return {};
  return f[0] + linearPart(f, first);
}

Region Region::simplex(const std::vector<Point>& vertices)
{
  Region region{vertices, vertices};
  Point middle{};
  for (const auto& vertex : vertices)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += vertex[k] / double(vertices.size());
  for (auto& direction : region.directions)
    for (std::size_t k = 0; k < 3; ++k)
      direction[k] -= middle[k];
  return region;
}

Region Region::box(int dim, const Point& middle, double halfWidth, double step)
{
  Region region;
  for (int corner = 0; corner < 1 << dim; ++corner) {
    Point x = middle, d{};
    for (int k = 0; k < dim; ++k) {
      const double side = (corner >> k) % 2 == 0 ? -1.0 : 1.0;
      x[std::size_t(k)] += side * halfWidth;
      d[std::size_t(k)] = side * step;
    }
    region.points.push_back(x);
    region.directions.push_back(d);
  }
  return region;
}

Interval rangeOf(const AffineFunction& f, const Region& region)
{
  return AffineRange(f, region).value;
}

} // namespace ndframe
