// Brings two bodies into contact, directly and by the Neumann-Dirichlet iteration: one node closes, one opens.
#include <cmath>

#include "ndframe/coupling/coupling.hpp"

using namespace ndframe;

/// A body that is a spring at each of two nodes, with these loads along the normal.
BodyTrace springs(bool isDirichlet, double stiffness, const Vector& load)
{
  BodyTrace body;
  body.body = isDirichlet ? 0 : 1;
  body.unknowns = {0, 1};
  body.roles.assign(2, isDirichlet ? ContactRole::Dirichlet : ContactRole::Neumann);
  DenseMatrix S(2, 2);
  S(0, 0) = S(1, 1) = stiffness;
  body.S = makeDenseOperator(S);
  body.g = load;
  body.freeMotions = DenseMatrix(2, 0); // the springs are held
  return body;
}

/// Two nodes, at the ends of one edge of length 1, where the two bodies touch.
InterfaceSystem twoNodes()
{
  InterfaceMesh edge;
  edge.dim = 2, edge.order = 1;
  edge.points = {0.0, 0.0, 1.0, 0.0};
  edge.sides[0].nodes = edge.sides[1].nodes = edge.facets = {0, 1};
  edge.measures = {1.0};
  InterfaceSystem system;
  system.C = std::make_shared<ContactMatrix>(std::vector<InterfaceMesh>{edge});
  system.nodeOfUnknown = {0, 1};
  system.gap = system.obstacle = ofUnknowns({0.0, 0.0});
  system.isObstacle = {0, 0};
  system.bodies = {springs(true, 1.0, {4.0, -1.0}), springs(false, 3.0, {0.0, 0.0})};
  return system;
}

int main()
{
  const InterfaceSystem system = twoNodes();
  Registry<RelaxationController> relaxations("relaxation", "Automatic");
  registerRelaxations(relaxations);
  Registry<Coupling> couplings("coupling");
  registerCouplings(couplings, relaxations);
  bool ok = true;
  for (const std::string type : {"Monolithic", "Neumann-Dirichlet"}) {
    Ledger ledger;
    const auto observe = [](const SweepRecord&, const InterfaceState&) {}; // a program may show the sweeps here
    const CouplingResult result = couplings.build({"Type=" + type})->solve(system, observe, ledger);
    // Closed: 1 u + 3 u = 4, the force on the first body is 1 u - 4. Open: each spring by itself. All springs of a body
    // are alike, so that the sweeps have one eigenvalue and the best relaxation makes them exact.
    const InterfaceState& state = result.state;
    ok = ok && result.converged && state.closed == std::vector<char>{1, 0};
    ok = ok && std::abs(state.uDirichlet[0] - 1.0) < 1e-12 && std::abs(state.forceDirichlet[0] + 3.0) < 1e-12;
    ok = ok && std::abs(state.uDirichlet[1] + 1.0) < 1e-12 && std::abs(state.forceDirichlet[1]) < 1e-12;
  }
  return ok ? 0 : 1;
}
