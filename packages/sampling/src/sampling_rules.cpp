#include "ndframe/sampling/sampling_rules.hpp"

#include <algorithm>

#include "ndframe/sampling/point_sums.hpp"

namespace ndframe
{
namespace
{

std::vector<double> paddedCoordinates(const QuadratureRule& rule)
{
  const std::size_t count = std::size_t(rule.size()), corners = std::size_t(rule.dim) + 1;
  const std::size_t stride = paddedCount(rule.size());
  std::vector<double> all(corners * stride, 0.0);
  for (std::size_t q = 0; q < count; ++q)
    for (std::size_t v = 0; v < corners; ++v)
      all[v * stride + q] = rule.lambda[q * corners + v];
  return all;
}

std::vector<SamplingRule> ladderOf(int dim, const std::vector<int>& degrees, int highest)
{
  std::vector<SamplingRule> rules;
  for (const int degree : degrees) {
    rules.push_back({dim == 1 ? simplexRule(dim, degree) : compactRule(dim, degree),
                     std::min(degree - degreeOfMoments(dim), highest), std::min(degree / 2, highest)});
    rules.back().padded = paddedCoordinates(rules.back().rule);
  }
  return rules;
}

std::vector<SamplingRule> ladderForPieces(int dim, const std::vector<int>& degrees)
{
  std::vector<SamplingRule> rules = ladderOf(dim, degrees, highestKept);
  for (SamplingRule& sampling : rules)
    if (dim == 1 || &sampling == &rules.back())
      sampling.kept = std::min(sampling.kept, sampling.squared);
  return rules;
}

} // namespace

const std::vector<SamplingRule>& samplingLadder(int dim)
{
  static const auto edges = ladderForPieces(1, {6, 8, 12, 18}),
                    triangles = ladderForPieces(2, {4, 5, 6, 8, 9, 10, 12, 18}),
                    tetrahedra = ladderForPieces(3, {5, 7, 9, 13});
  return dim == 1 ? edges : dim == 2 ? triangles : tetrahedra;
}

const std::vector<SamplingRule>& smoothLadder(int dim)
{
  static const auto triangles =
                        ladderOf(2, {4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 21, 23, 25, 27}, highestKeptWhole),
                    tetrahedra =
                        ladderOf(3, {5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 21, 23, 25, 27}, highestKeptWhole);
  return dim == 2 ? triangles : dim == 3 ? tetrahedra : samplingLadder(dim);
}

} // namespace ndframe
