#include "data_enclosures.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/sampling/sampling_rules.hpp"

namespace ndframe
{
namespace
{

int largestKept(int dim)
{
  return samplingLadder(dim).back().kept;
}

/// What is known of a polynomial without looking: it is one.
Enclosure ofPolynomial(int degree)
{
  Enclosure enclosure;
  for (int n = 0; n <= Enclosure::longest; ++n)
    enclosure.remainder[std::size_t(n)] = n > degree ? 0.0 : std::numeric_limits<double>::infinity();
  return enclosure;
}

/// The place of an expression among the operations of another; -1: it is none of them.
int placeOf(const ExpressionTree& part, const ExpressionTree& tree)
{
  for (int place = 0; place < int(tree.nodes().size()); ++place)
    if (tree.nodes()[std::size_t(place)].operation == part.root().operation && tree.part(place).isSame(part))
      return place;
  return -1;
}

/// Centroid and largest distance from it along an axis.
std::pair<Region::Point, double> extent(const std::vector<Region::Point>& corners)
{
  const Region region = Region::simplex(corners);
  Region::Point middle{};
  double radius = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    middle[k] = corners[0][k] - region.directions[0][k];
    for (const auto& direction : region.directions)
      radius = std::max(radius, std::abs(direction[k]));
  }
  return {middle, radius};
}

} // namespace

DataEnclosures::DataEnclosures(const std::vector<SampledFunction>& functions, int space)
{
  for (const auto& function : functions) {
    trees_.push_back(function.tree.get());
    boxes_.emplace_back(*trees_.back(), space);
  }
}

bool DataEnclosures::arePolynomials() const
{
  return std::all_of(trees_.begin(), trees_.end(), [](const auto* tree) { return tree->root().degree >= 0; });
}

std::vector<Enclosure> DataEnclosures::on(int dim, const std::vector<Region::Point>& corners, bool isWhole,
                                          double enough)
{
  std::vector<Enclosure> all;
  const int kept = largestKept(dim);
  for (std::size_t f = 0; f < trees_.size(); ++f) {
    const int degree = trees_[f]->root().degree;
    if (degree >= 0 && degree <= kept) {
      all.push_back(ofPolynomial(degree));
      continue;
    }
    if (isWhole) {
      const auto [middle, radius] = extent(corners);
      all.push_back(boxes_[f].around(middle, radius));
      if (all.back().distance(kept) <= enough)
        continue;
      all.pop_back();
    }
    all.push_back(enclose(*trees_[f], Region::simplex(corners)));
  }
  return all;
}

double DataEnclosures::largestAround(const SimplexGeometry& simplex)
{
  double largest = 0.0;
  const auto [middle, radius] = extent(simplex.corners(simplex.whole()));
  for (auto& boxes : boxes_)
    largest = std::max(largest, boxes.around(middle, radius).range.magnitude());
  return largest;
}

double DataEnclosures::largestBetween(const std::vector<Region::Point>& corners) const
{
  double largest = 0.0;
  const Region region = Region::simplex(corners);
  for (const auto* tree : trees_)
    largest = std::max(largest, enclose(*tree, region).range.magnitude());
  return largest;
}

SwitchedEnclosures DataEnclosures::onSides(const std::vector<Region::Point>& corners, DataSwitch at) const
{
  SwitchedEnclosures both;
  const Region region = Region::simplex(corners);
  const ExpressionTree function = part(at);
  for (std::size_t f = 0; f < trees_.size(); ++f) {
    const int place = f == at.function ? at.place : placeOf(function, *trees_[f]);
    for (const double sign : {-1.0, 1.0})
      both.sides.push_back(enclose(*trees_[f], region, -1, Enclosure::order, {place, sign}));
    both.jump = std::max(both.jump, 2.0 * enclose(*trees_[f], region, -1, 1).remainder[0]);
  }
  return both;
}

std::optional<AffineFunction> DataEnclosures::steepest(int dim, const std::vector<Region::Point>& corners,
                                                       std::size_t function, double error) const
{
  constexpr double share = 0.1; ///< of the error, which one function alone should explain
  if (dim == 1)
    return {};
  const Region region = Region::simplex(corners);
  const auto& nodes = trees_[function]->nodes();
  std::optional<AffineFunction> best;
  std::pair<double, double> most{share * error, 0.0}; // infinite errors: the larger range counts
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!nodes[n].isFeature)
      continue;
    const Enclosure alone = enclose(*trees_[function], region, int(n));
    const std::pair<double, double> explained{alone.distance(largestKept(dim)), alone.remainder[0]};
    if (explained <= most)
      continue;
    most = explained;
    best = nodes[n].affine;
    (*best)[0] -= rangeOf(nodes[n].affine, region).middle();
  }
  return best;
}

} // namespace ndframe
