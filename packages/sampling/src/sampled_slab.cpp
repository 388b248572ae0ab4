#include "sampled_slab.hpp"

#include <cmath>

namespace ndframe
{
namespace
{

AffineFunction minus(AffineFunction f, double value)
{
  f[0] -= value;
  return f;
}

double product(const AffineFunction& a, const AffineFunction& b)
{
  return a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The value of g where f = 0, when they are parallel.
std::optional<double> valueWhere(const AffineFunction& f, const AffineFunction& g)
{
  constexpr double parallel = 1e-12;
  const double factor = product(f, g) / product(f, f);
  for (std::size_t i = 1; i < f.size(); ++i)
    if (std::abs(g[i] - factor * f[i]) > parallel * std::sqrt(product(g, g)))
      return {};
  return g[0] - factor * f[0];
}

double valueIn(const SimplexGeometry& simplex, const Samples::Piece& piece, const AffineFunction& f)
{
  double sum = 0.0;
  for (const auto& x : simplex.corners(piece))
    sum += f[0] + f[1] * x[0] + f[2] * x[1] + f[3] * x[2];
  return sum;
}

/// The parts of pieces where f has a sign.
std::vector<Samples::Piece> onSide(const SimplexGeometry& simplex, const std::vector<Samples::Piece>& pieces,
                                   const AffineFunction& f, double sign)
{
  std::vector<Samples::Piece> kept;
  for (const auto& piece : pieces)
    for (const auto& part : simplex.cut(piece, f))
      if (sign * valueIn(simplex, part, f) > 0.0)
        kept.push_back(part);
  return kept;
}

} // namespace

double SampledSlab::fraction() const
{
  double sum = 0.0;
  for (const auto& part : parts_)
    sum += part.fraction;
  return sum;
}

std::vector<Region::Point> SampledSlab::corners(const SimplexGeometry& simplex) const
{
  std::vector<Region::Point> all;
  for (const auto& part : parts_)
    for (const auto& corner : simplex.corners(part))
      all.push_back(corner);
  return all;
}

SampledSlab SampledSlab::between(const SimplexGeometry& simplex, const AffineFunction& f, Interval range) const
{
  SampledSlab slab(base_);
  slab.across_ = f;
  slab.range_ = range;
  slab.parts_ = onSide(simplex, slab.parts_, minus(f, range.lo), 1.0);
  slab.parts_ = onSide(simplex, slab.parts_, minus(f, range.hi), -1.0);
  return slab;
}

std::vector<SampledSlab> SampledSlab::single() const
{
  std::vector<SampledSlab> all;
  for (const auto& part : parts_)
    all.emplace_back(part);
  return all;
}

std::vector<SampledSlab> SampledSlab::cut(const SimplexGeometry& simplex, const AffineFunction& f) const
{
  const auto value = across_ ? valueWhere(f, *across_) : 0.0;
  if (!value)
    return parts_.size() > 1 ? single() : SampledSlab(parts_.front()).cut(simplex, f);
  const AffineFunction g = across_ ? *across_ : f;
  const Interval range = across_ ? range_ : rangeOf(f, Region::simplex(corners(simplex)));
  std::vector<SampledSlab> halves;
  if (*value > range.lo && *value < range.hi)
    for (const Interval side : {Interval{range.lo, *value}, Interval{*value, range.hi}})
      if (SampledSlab half = between(simplex, g, side); !half.parts_.empty())
        halves.push_back(std::move(half));
  return halves.size() > 1 ? halves : std::vector<SampledSlab>{};
}

std::vector<SampledSlab> SampledSlab::bisect(const SimplexGeometry& simplex) const
{
  if (parts_.size() > 1)
    return single();
  std::vector<SampledSlab> halves;
  for (const auto& half : simplex.bisect(parts_.front()))
    halves.emplace_back(half);
  return halves;
}

} // namespace ndframe
