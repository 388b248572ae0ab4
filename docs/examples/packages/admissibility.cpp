// Finds the contact traction nearest to a computed one that presses everywhere and carries the weight of a loose block.
#include <cmath>

#include "ndframe/admissibility/admissible_traction.hpp"

int main()
{
  using namespace ndframe;
  ContactPatch patch; // one edge of length 1, of first order
  patch.sides[1].body = 1;
  patch.normal = {0.0, -1.0, 0.0};
  patch.measure = 1.0;
  patch.nodes = {0, 1};
  const std::vector<ContactPatch> patches{patch};
  const int order = 1, nodes = 2;

  BalanceConditions balance; // upwards: against n_c, and against the weight 1/2, whose work is - 1/2
  balance.work = SparseColumns(nodes, 1);
  balance.work.setColumn(0, Vector{-0.5, -0.5});
  balance.value = {0.5};
  balance.names = {"translation along y of block"};

  // With the right resultant, (1, -1) becomes (1/2, -3/2); it still pulls at the first node, which must let go.
  const Vector t = projectTraction(patches, nodes, order, {1.0, -1.0}, balance);
  bool ok = std::abs(t[0]) < 1e-14 && std::abs(t[1] + 1.0) < 1e-14;

  const ContactTraction traction = tractionFromNodes(patches, t, order, order);
  ok = ok && largestBernstein(traction, patches) < 1e-14;    // presses everywhere
  ok = ok && std::abs(traction.moments(0)[0] + 0.5) < 1e-14; // the first moment is the force
  return ok ? 0 : 1;
}
