// Assembles a square that is pulled at its right side and shows that the exact solution solves the linear system.
#include <cmath>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/assembly/fields.hpp"

int main()
{
  using namespace ndframe;
  Registry<Support> supports("support");
  registerSupports(supports);
  Registry<Load> loads("load");
  registerLoads(loads);
  BodyModel body; // the unit square as two triangles; Young's modulus 1, no lateral contraction
  body.mesh.dim = 2;
  body.mesh.points = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  body.mesh.cells = {0, 1, 2, 0, 2, 3};
  body.mesh.sides = {{"right", {{0, 0}}}, {"left", {{1, 1}}}};
  body.nodes = makeNodeMap(body.mesh, 1);
  body.laws = Elasticity{2, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5}, {}};
  body.supports.push_back(supports.build({"Type=Clamp", "Side=left"}));
  body.loads.push_back(loads.build({"Type=Traction", "Side=right", "X=3"}));

  const ConstraintSet held = collectConstraints(body.supports, body.mesh, body.nodes);
  const BodySystem system = assembleBody(body, makeDofLayout(body.nodes, held, {}), {0, 1, 2, 3});
  const Vector u{0.0, 0.0, 3.0, 0.0, 3.0, 0.0, 0.0, 0.0}; // u = 3 x, the stress is 3
  const Vector force = multiply(system.K, u, Comm::single());
  const NodalField load = system.load.all();
  bool ok = std::abs(energy(body, u) - 9.0) < 1e-14; // a(u, u) = E strain^2
  for (std::size_t dof = 0; dof < u.size(); ++dof)
    ok = ok && (system.dofs.roles[dof] == DofRole::Fixed || std::abs(force[dof] - load[dof]) < 1e-14);
  return ok ? 0 : 1;
}
