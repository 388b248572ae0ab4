#include "sampling_rules.hpp"

#include <algorithm>

#include "triangle_rules.hpp"

namespace ndframe
{
namespace
{

constexpr int highest = 9; ///< degree of the polynomials that enclosures compare with

std::vector<SamplingRule> ladderOf(int dim, const std::vector<int>& degrees)
{
  std::vector<SamplingRule> rules;
  for (const int degree : degrees) {
    const bool isSymmetric = dim == 2 && hasSymmetricTriangleRule(degree);
    rules.push_back({isSymmetric ? symmetricTriangleRule(degree) : simplexRule(dim, degree),
                     std::min(degree - (5 - dim), highest), std::min(degree / 2, highest)});
    if (dim == 1 || degree == degrees.back())
      rules.back().kept = std::min(rules.back().kept, rules.back().squared);
  }
  return rules;
}

} // namespace

const std::vector<SamplingRule>& samplingLadder(int dim)
{
  static const auto edges = ladderOf(1, {6, 8, 12, 18}), triangles = ladderOf(2, {4, 5, 6, 8, 10, 12, 18}),
                    tetrahedra = ladderOf(3, {5, 7, 9, 13}); // the collapsed rules of 4, 5, 6 and 8 points an axis
  return dim == 1 ? edges : dim == 2 ? triangles : tetrahedra;
}

} // namespace ndframe
