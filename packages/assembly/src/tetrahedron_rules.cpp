#include "tetrahedron_rules.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Points that are the permutations of four barycentric coordinates, each with this weight.
struct Orbit
{
  std::array<double, 4> lambda;
  double weight;
};

/// Of one coordinate and three that are equal.
Orbit three(double a, double weight)
{
  return {{a, a, a, 1.0 - 3.0 * a}, weight};
}

/// Of two pairs.
Orbit pairs(double a, double weight)
{
  return {{a, a, 0.5 - a, 0.5 - a}, weight};
}

/// Of one pair and two others.
Orbit pair(double a, double b, double weight)
{
  return {{a, a, b, 1.0 - 2.0 * a - b}, weight};
}

const std::map<int, std::vector<Orbit>>& orbits() ///< by degree
{
  static const std::map<int, std::vector<Orbit>> all = {
      {5,
       {three(0.0927352503108912264, 0.0734930431163619496), three(0.310885919263300610, 0.112687925718015851),
        pairs(0.0455037041256496495, 0.0425460207770814664)}},
      {7,
       {{{0.25, 0.25, 0.25, 0.25}, 0.0954852894641308532},
        three(0.3157011497782028, 0.0423295812099670279),
        pairs(0.449510177401603631, 0.0318969278328575803),
        pair(0.0212654725414832459, 0.810830241098548562, 0.0081107708299033415),
        pair(0.188833831026001047, 0.575171637587000024, 0.0372071307283346212)}},
      {9,
       {{{0.25, 0.25, 0.25, 0.25}, 0.0579862418830044543},
        three(0.322096387355119892, 0.0299654375429797108),
        three(0.163798688665462481, 0.0242560679834061123),
        three(0.0390337087620251465, 0.00523257686678609241),
        three(0.0601141886031133325, 0.0032591501923297499),
        pairs(0.109924417915718654, 0.0374820789496235283),
        pair(0.183806591216119353, 0.0343770408662682989, 0.0205240130048448231),
        pair(0.0337960272359284424, 0.71839331937547855, 0.0102458286337421854),
        pair(0.459556354079009463, 0.0793348018115910624, 0.00808585453451696775)}}};
  return all;
}

} // namespace

bool hasSymmetricTetrahedronRule(int degree)
{
  return orbits().count(degree) > 0;
}

QuadratureRule symmetricTetrahedronRule(int degree)
{
  NDFRAME_ASSERT(hasSymmetricTetrahedronRule(degree), "a rule of another degree");
  QuadratureRule rule{3, {}, {}};
  for (const Orbit& orbit : orbits().at(degree)) {
    std::array<double, 4> lambda = orbit.lambda;
    std::sort(lambda.begin(), lambda.end());
    do {
      rule.lambda.insert(rule.lambda.end(), lambda.begin(), lambda.end());
      rule.weights.push_back(orbit.weight);
    } while (std::next_permutation(lambda.begin(), lambda.end()));
  }
  return rule;
}

} // namespace ndframe
