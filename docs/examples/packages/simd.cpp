// Computes cell by cell how far an equilibrated stress, a uniform tension, is from the stress of a displacement: the
// energy of the tension for a body at rest, and nothing for the displacement that belongs to it.
#include <cmath>

#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/simd/cell_distances.hpp"

int main()
{
  using namespace ndframe;
  const double E = 210.0, G = E / 2.0, tension = 3.0; // Poisson's ratio is zero
  const auto stiffness = orthotropicStiffness({1 / E, 0, 0, 0, 1 / E, 0, 0, 0, 1 / E}, {G, G, G});
  BodyModel body;
  body.mesh = {2, {0, 0, 2, 0, 2, 1, 0, 1}, {0, 1, 2, 0, 2, 3}, {}, {}}; // two cells of area 1
  body.nodes = makeNodeMap(body.mesh, 1);
  body.laws = reduceTo(Hypothesis::PlaneStrain, *stiffness);

  StressCorrection stress; // by its tractions: it has no divergence
  stress.dim = 2;
  stress.degree = 1;
  stress.loads.assign(std::size_t(2 * loadBasis(2, 1).size() * 2), 0.0);
  for (int cell = 0; cell < 2; ++cell)
    for (int facet = 0; facet < 3; ++facet) { // the vertices of both cells ascend
      double normal[2];
      const double length = facetNormal(body.mesh, {cell, facet}, normal);
      // The moments of a constant: its resultant, and zero for the function that is linear.
      stress.tractions.insert(stress.tractions.end(), {length * normal[0] * tension, 0.0, 0.0, 0.0});
    }

  Vector opposite; // u~ - u, where u~ = 0 and u is the displacement of the tension
  for (int node = 0; node < 4; ++node)
    opposite.insert(opposite.end(), {-tension / E * body.nodes.point(node)[0], 0.0});
  const Vector atRest = cellDistances(body, stress, nullptr), pulled = cellDistances(body, stress, &opposite);
  bool ok = true;
  for (std::size_t cell = 0; cell < 2; ++cell)
    ok = ok && std::abs(atRest[cell] - tension * tension / E) < 1e-15 && std::abs(pulled[cell]) < 1e-15;
  return ok ? 0 : 1;
}
