#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe::test
{

/// Makes n_c a continuous field: at a vertex the mean of its facets', at ends of the chain turned a little.
inline void turnFacets(std::vector<ContactFacet>& facets)
{
  std::map<int, Direction> sums;
  std::map<int, int> count;
  for (const ContactFacet& facet : facets)
    for (const std::size_t end : {0u, 1u})
      for (std::size_t k = 0; k < 2; ++k) {
        sums[facet.nodes[end]][k] += facet.normal[k];
        count[facet.nodes[end]] += k == 0;
      }
  for (ContactFacet& facet : facets) {
    facet.turns = true;
    for (const std::size_t end : {0u, 1u}) {
      const int node = facet.nodes[end];
      facet.ends[end] = sums[node];
      if (count[node] == 1)
        facet.ends[end][0] += 0.1;
      const double length = std::hypot(facet.ends[end][0], facet.ends[end][1]);
      for (std::size_t k = 0; k < 2; ++k)
        facet.ends[end][k] /= length;
    }
  }
}

} // namespace ndframe::test
