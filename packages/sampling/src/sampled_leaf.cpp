#include "sampled_leaf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "switch_curve.hpp"

namespace ndframe
{
namespace
{

constexpr double negligible = 1e-14; ///< what functions may miss, times the share of the simplex where they miss it
/// The share of a simplex that may lie on the other side of a curve when functions jump by their scale. Parts of a
/// triangle may have as much as their length.
constexpr double openShare = 4e-11;

/// A bound of the derivative of f minus the polynomial through the points of a rule along a piece of length 1: that of
/// f minus its Taylor polynomial, and of the polynomial through their difference by Markov's inequality. The
/// polynomials that are 1 at one Gauss point and 0 at the others add up to less than their number.
double slopeError(const Enclosure& enclosure, const SamplingRule& sampling)
{
  const double points = sampling.rule.size(), markov = 2.0 * (points - 1.0) * (points - 1.0);
  double least = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= std::min(sampling.kept + 1, Enclosure::order); ++n)
    least = std::min(least, (2.0 * n + markov * points) * enclosure.remainder[std::size_t(n)]);
  return least;
}

/// Finds the first rule for which functions, as enclosed on the leaf's slab, miss little enough.
void settle(const std::vector<Enclosure>& enclosures, int dim, double scale, SampledLeaf& leaf)
{
  const double allowed = agreementOn(dim) * scale, fraction = leaf.slab.fraction();
  for (const SamplingRule& sampling : samplingLadder(dim)) {
    leaf.sampling = &sampling;
    leaf.error = leaf.normError = leaf.slopeError = 0.0;
    for (std::size_t f = 0; f < enclosures.size(); ++f) {
      const double error = enclosures[f].distance(sampling.kept);
      if (error > leaf.error)
        leaf.worst = f;
      leaf.error = std::max(leaf.error, error);
      leaf.normError = std::max(leaf.normError, enclosures[f].distance(sampling.squared));
      if (dim == 1)
        leaf.slopeError = std::max(leaf.slopeError, slopeError(enclosures[f], sampling));
    }
    leaf.isSettled = (leaf.error <= allowed && leaf.normError <= agreementOfNorms * scale) ||
                     fraction * std::max(leaf.error, leaf.normError) <= negligible * scale;
    if (leaf.isSettled)
      break;
  }
}

/// Gives a leaf the two sides of a curve; false where it is not located.
bool cutAlong(const ExpressionTree& s, const SimplexGeometry& simplex, double scale, double jump, SampledLeaf& leaf)
{
  const Samples::Piece& triangle = leaf.slab.parts().front();
  const int degree = std::max(leaf.sampling->kept + 5 - simplex.dim(), 2 * leaf.sampling->squared);
  const double allowed = openShare * std::sqrt(triangle.fraction) * scale / jump;
  const auto curve = SwitchCurve::find(s, simplex, triangle, degree, allowed);
  if (!curve)
    return false;
  for (const double sign : {-1.0, 1.0})
    if (QuadratureRule side = curve->side(sign); side.size() > 0)
      leaf.sides.push_back(std::move(side));
  if (leaf.sides.size() == 1) // the curve is not in the triangle: its own rule serves
    leaf.sides.clear();
  leaf.openError = 0.5 * jump * curve->open(); // by the rule and by the integral already
  leaf.openSquare = jump * jump * curve->open();
  return true;
}

} // namespace

SampledLeaf resolve(const SimplexGeometry& simplex, SampledSlab slab, double scale, DataEnclosures& data)
{
  const double allowed = agreementOn(simplex.dim()) * scale;
  const auto enclosures = data.on(simplex.dim(), slab.corners(simplex), slab.isWhole(), allowed);
  SampledLeaf leaf(std::move(slab));
  settle(enclosures, simplex.dim(), scale, leaf);
  for (std::size_t f = 0; f < enclosures.size(); ++f) {
    if (!leaf.cut)
      leaf.cut = enclosures[f].cut;
    if (leaf.curve.place < 0)
      leaf.curve = {f, enclosures[f].curved};
  }
  return leaf;
}

std::optional<SampledLeaf> settledOnSides(const SimplexGeometry& simplex, const SampledLeaf& leaf, double scale,
                                          const DataEnclosures& data)
{
  const auto both = data.onSides(leaf.slab.corners(simplex), leaf.curve);
  SampledLeaf settled(leaf.slab);
  settle(both.sides, simplex.dim(), scale, settled);
  if (!settled.isSettled || !std::isfinite(both.jump))
    return {};
  settled.areSidesFound = cutAlong(data.part(leaf.curve), simplex, scale, both.jump, settled);
  return settled;
}

std::vector<SampledSlab> split(const SimplexGeometry& simplex, const SampledLeaf& leaf, const DataEnclosures& data)
{
  const auto across =
      leaf.cut ? leaf.cut : data.steepest(simplex.dim(), leaf.slab.corners(simplex), leaf.worst, leaf.error);
  if (across)
    if (auto slabs = leaf.slab.cut(simplex, *across); !slabs.empty())
      return slabs;
  return leaf.slab.bisect(simplex);
}

} // namespace ndframe
