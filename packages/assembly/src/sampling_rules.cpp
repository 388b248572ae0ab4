#include "sampling_rules.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

constexpr int testDegree = 4; ///< phi_a L_k of degree 1 + 3 is the highest that stars integrate

template <int dim>
const std::vector<SamplingRule>& ladderOf()
{
  static const std::vector<SamplingRule> ladder = [] {
    std::vector<SamplingRule> rules;
    for (const int degree : {6, 8, 12, 18})
      if (dim < 3 || degree < 18) // a thousand points in a tetrahedron
        rules.push_back({simplexRule(dim, degree), std::min(degree / 2, degree - testDegree)});
    return rules;
  }();
  return ladder;
}

} // namespace

const std::vector<SamplingRule>& samplingLadder(int dim)
{
  return dim == 1 ? ladderOf<1>() : dim == 2 ? ladderOf<2>() : ladderOf<3>();
}

} // namespace ndframe
