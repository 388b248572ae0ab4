// Finds the contact traction nearest to a computed one that presses everywhere and carries the weight of a loose block.
#include <cmath>

#include "ndframe/admissibility/admissible_traction.hpp"

int main()
{
  using namespace ndframe;
  ContactFacet facet; // one edge of length 1, of first order
  facet.neumannBody = 1;
  facet.normal = {0.0, -1.0, 0.0};
  facet.measure = 1.0;
  facet.nodes = {0, 1};
  const std::vector<ContactFacet> facets{facet};
  const int order = 1, nodes = 2;

  BalanceConditions balance; // upwards: against n_c, and against the weight 1/2, whose work is - 1/2
  balance.work = SparseColumns(nodes, 1);
  balance.work.setColumn(0, Vector{-0.5, -0.5});
  balance.value = {0.5};
  balance.names = {"translation along y of block"};

  // With the right resultant, (1, -1) becomes (1/2, -3/2); it still pulls at the first node, which must let go.
  const Vector t = projectTraction(facets, nodes, order, {1.0, -1.0}, balance);
  bool ok = std::abs(t[0]) < 1e-14 && std::abs(t[1] + 1.0) < 1e-14;

  const ContactTraction traction = tractionFromNodes(facets, t, order, order);
  ok = ok && largestBernstein(traction, facets) < 1e-14;     // presses everywhere
  ok = ok && std::abs(traction.moments(0)[0] + 0.5) < 1e-14; // the first moment is the force
  return ok ? 0 : 1;
}
