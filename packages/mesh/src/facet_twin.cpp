#include "ndframe/mesh/facet_twin.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

double squaredDistance(const double* a, const double* b)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
    sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

bool areOpposite(const Mesh& a, Facet facetA, const Mesh& b, Facet facetB)
{
  constexpr double near = 0.1; // of the facet's size
  std::array<double, 3> normalA{}, normalB{};
  const double area = std::min(facetNormal(a, facetA, normalA.data()), facetNormal(b, facetB, normalB.data()));
  const double cosine = normalA[0] * normalB[0] + normalA[1] * normalB[1] + normalA[2] * normalB[2];
  return cosine < 0.0 &&
         squaredDistance(facetCentre(a, facetA).data(), facetCentre(b, facetB).data()) < near * near * area;
}

} // namespace

std::array<std::pair<int, int>, 3> sameVertices(const Mesh& a, Facet facetA, const Mesh& b, Facet facetB)
{
  NDFRAME_ASSERT(areOpposite(a, facetA, b, facetB), "twins lie on each other, with their bodies on different sides");
  std::array<int, 3> ofA{}, ofB{};
  facetVertices(a, facetA, ofA.data());
  facetVertices(b, facetB, ofB.data());
  std::array<std::pair<int, int>, 3> pairs;
  for (std::size_t k = 0; k < 3; ++k) {
    const double* place = a.point(ofA[k]);
    const auto rest = ofB.begin() + std::ptrdiff_t(k);
    std::iter_swap(rest, std::min_element(rest, ofB.end(), [&](int v, int w) {
                     return squaredDistance(b.point(v), place) < squaredDistance(b.point(w), place);
                   }));
    pairs[k] = {ofA[k], ofB[k]};
  }
  return pairs;
}

} // namespace ndframe
