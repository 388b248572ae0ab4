// Makes a stress in equilibrium with the loads from the finite element solution of a square that sags by its weight.
#include <cmath>

#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/assembly/body_loads.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/equilibrium_check.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

int main()
{
  using namespace ndframe;
  Registry<Support> supports("support");
  registerSupports(supports);
  Registry<Load> loads("load");
  registerLoads(loads);
  Registry<StressRecovery> recoveries("recovery");
  registerRecoveries(recoveries);
  BodyModel body; // four triangles around one node; Young's modulus 1, no lateral contraction
  body.mesh.dim = 2;
  body.mesh.points = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.5, 0.5};
  body.mesh.cells = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  body.mesh.sides = {{"walls", {{0, 2}, {1, 2}, {2, 2}, {3, 2}}}};
  body.nodes = makeNodeMap(body.mesh, 1);
  body.laws = Elasticity{2, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5}, {}};
  body.supports.push_back(supports.build({"Type=Clamp", "Side=walls"}));
  body.loads.push_back(loads.build({"Type=Body Force", "Y=-1"}));

  Vector sag(10, 0.0);
  sag[9] = 1.0;                                 // the node in the middle, along y
  const double stiffness = energy(body, sag);   // 3, by hand
  sag[9] = integrateLoads(body)[9] / stiffness; // - 1/3 of the load on its cells: u = - 1/9
  bool ok = std::abs(sag[9] + 1.0 / 9.0) < 1e-14;

  const auto recovery = recoveries.build({"Type=Star"});
  RecoveryScene scene;
  scene.bodies = {&body};
  scene.data.push_back(makeStaticData(body, recovery->degree(body.nodes.order), {}));
  SceneField field;
  field.displacement = {&sag};
  Ledger ledger;
  const auto stress = recovery->recover(scene, {field}, Comm::single(), ledger).front();
  const StressCorrection& correction = stress.corrections.front();
  ok = ok && ledger.counted("stars") == 5; // one for each vertex
  ok = ok && checkEquilibrium(body, scene.data.front(), {&sag, nullptr}, correction).largest() < 1e-13;
  return ok ? 0 : 1;
}
