// Bounds the error of approximate displacements by a stress in equilibrium, and brackets the exact energy.
#include <cmath>

#include "ndframe/assembly/fields.hpp"
#include "ndframe/estimation/energy_bracket.hpp"

int main()
{
  using namespace ndframe;
  BodyModel body; // the unit square as two triangles; Young's modulus 1, no lateral contraction
  body.mesh.dim = 2;
  body.mesh.points = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  body.mesh.cells = {0, 1, 2, 0, 2, 3};
  body.nodes = makeNodeMap(body.mesh, 1);
  body.laws = Elasticity{2, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5}, {}};

  // A bar held at x = 0 and pulled by 1 at x = 1: u = x with the energy 1/2 - 1. The approximation is c x; the stress
  // that is in equilibrium with the load is 1, that of u = x.
  const auto stretch = [](double a) { return Vector{0.0, 0.0, a, 0.0, a, 0.0, 0.0, 0.0}; };
  EnergyRecord record;
  bool ok = true;
  for (const double c : {0.6, 0.9, 1.2}) {
    const ErrorMeasure measure = assembleMeasure({cellEnergies(body, stretch(1.0 - c))}, {}, {});
    ok = ok && std::abs(measure.elements - std::abs(1.0 - c)) < 1e-14; // the error in the energy norm
    ok = ok && std::abs(measure.bound() - measure.elements) < 1e-14;   // which the bound meets here
    const double work = c;                                             // of the load
    ok = ok && !record.add(bracketEnergy(measure, energy(body, stretch(c)), work), "c x");
  }
  ok = ok && record.holds() && record.certificates() == 3;
  ok = ok && std::abs(record.lower() + 0.5) < 1e-14;                   // the stress is the exact one
  ok = ok && std::abs(record.upper() - (0.9 * 0.9 / 2 - 0.9)) < 1e-14; // of the best displacement
  return ok ? 0 : 1;
}
