#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe::test
{

/// Makes n_c a continuous field: at a vertex the mean of its facets', at ends of the chain turned a little.
inline void turnFacets(std::vector<ContactPatch>& patches)
{
  std::map<int, Direction> sums;
  std::map<int, int> count;
  for (const ContactPatch& patch : patches)
    for (const std::size_t end : {0u, 1u})
      for (std::size_t k = 0; k < 2; ++k) {
        sums[patch.nodes[end]][k] += patch.normal[k];
        count[patch.nodes[end]] += k == 0;
      }
  for (ContactPatch& patch : patches) {
    patch.turns = true;
    for (const std::size_t end : {0u, 1u}) {
      const int node = patch.nodes[end];
      patch.ends[end] = sums[node];
      if (count[node] == 1)
        patch.ends[end][0] += 0.1;
      const double length = std::hypot(patch.ends[end][0], patch.ends[end][1]);
      for (std::size_t k = 0; k < 2; ++k)
        patch.ends[end][k] /= length;
    }
  }
}

} // namespace ndframe::test
