#include "coupling/sample_systems.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"
#include "subdomain/sample_problems.hpp"

namespace ndframe::test
{

namespace
{

Params validated(const std::string& name, const std::string& entries, const Choices& choices)
{
  ListSpec spec;
  spec.name = name;
  spec.choices = choices;
  Diagnostics diagnostics;
  const Params params = validate(parseDeck(list(name, entries), "test.xml"), spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

void expectNear(const Vector& a, const Vector& b, double tolerance, const char* what)
{
  ASSERT_EQ(a.size(), b.size());
  double scale = 0.0;
  for (const double value : b)
    scale = std::max(scale, std::abs(value));
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance * scale) << what << " " << i;
}

} // namespace

Registry<RelaxationController>& relaxations()
{
  static Registry<RelaxationController> registry = [] {
    Registry<RelaxationController> shipped("relaxation", "Constant");
    registerRelaxations(shipped);
    return shipped;
  }();
  return registry;
}

std::unique_ptr<RelaxationController> makeRelaxation(const std::string& entries)
{
  return relaxations().build(validated("Relaxation", entries, relaxations().choices()));
}

std::unique_ptr<Coupling> makeCoupling(const std::string& entries)
{
  Registry<Coupling> registry("coupling", "Neumann-Dirichlet");
  registerCouplings(registry, relaxations());
  return registry.build(validated("Coupling", entries, registry.choices()));
}

std::unique_ptr<Coupling> neumannDirichlet(double tolerance, const std::string& more, int maximumSweeps)
{
  return makeCoupling(text("Type", "Neumann-Dirichlet") + more +
                      list("Stopping", fmt::format("<Parameter name=\"Tolerance\" type=\"double\" value=\"{}\"/>"
                                                   "<Parameter name=\"Maximum Sweeps\" type=\"int\" value=\"{}\"/>",
                                                   tolerance, maximumSweeps)));
}

std::string relaxation(const std::string& type, const std::string& key, double value)
{
  return list("Relaxation",
              text("Type", type) + fmt::format("<Parameter name=\"{}\" type=\"double\" value=\"{}\"/>", key, value));
}

CouplingResult run(const Coupling& coupling, const InterfaceSystem& system)
{
  Ledger ledger;
  return run(coupling, system, ledger);
}

CouplingResult run(const Coupling& coupling, const InterfaceSystem& system, Ledger& ledger, const CouplingStart& start)
{
  return coupling.solve(
      system, [](const SweepRecord&, const InterfaceState&) {}, ledger, start);
}

InterfaceSystem emptySystem(int nodes)
{
  InterfaceSystem system;
  std::vector<double> x(static_cast<std::size_t>(nodes));
  std::iota(x.begin(), x.end(), 0.0);
  system.C = std::make_shared<ContactMatrix>(std::vector<InterfaceMesh>{straightInterface(x, 1)});
  system.nodeOfUnknown.resize(std::size_t(nodes));
  std::iota(system.nodeOfUnknown.begin(), system.nodeOfUnknown.end(), 0);
  system.gap = system.obstacle = ofUnknowns(Vector(std::size_t(nodes), 0.0));
  system.isObstacle.assign(std::size_t(nodes), 0);
  return system;
}

BodyTrace makeBody(std::vector<int> unknowns, bool isDirichlet, DenseMatrix S, Vector g, bool floats)
{
  BodyTrace body;
  body.roles.assign(unknowns.size(), isDirichlet ? ContactRole::Dirichlet : ContactRole::Neumann);
  body.freeMotions = rigidMotions(S.rows(), floats ? 1 : 0);
  body.motionNames = motionNames(floats ? 1 : 0);
  body.unknowns = std::move(unknowns);
  body.S = makeDenseOperator(std::move(S));
  body.g = std::move(g);
  return body;
}

DenseMatrix mildStiffness(int size, unsigned seed, double stiffness)
{
  DenseMatrix S = randomSpd(size, seed);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      S(i, j) = stiffness * (0.3 / size * S(i, j) + (i == j ? 1.0 : 0.0));
  return S;
}

DenseMatrix storedContactMatrix(const InterfaceSystem& system)
{
  DenseMatrix C(system.C->size(), system.C->size());
  for (int j = 0; j < C.cols(); ++j) {
    Vector e(std::size_t(C.rows()), 0.0);
    e[std::size_t(j)] = 1.0;
    const Vector column = system.C->apply(e);
    std::copy(column.begin(), column.end(), C.col(j));
  }
  return C;
}

DenseMatrix softChain(int size)
{
  DenseMatrix S = floatingChain(size);
  for (int i = 0; i < size * size; ++i)
    S.data()[i] *= 0.1;
  return S;
}

InterfaceSystem patchSystem()
{
  InterfaceSystem system = emptySystem(6);
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  system.bodies.push_back(makeBody(all, true, softChain(6), system.C->apply(Vector(6, 1.0)), true));
  system.bodies.push_back(makeBody(all, false, storedContactMatrix(system), Vector(6, 0.0)));
  return system;
}

InterfaceSystem randomSystem(unsigned seed, bool floats)
{
  const int n = 9;
  InterfaceSystem system = emptySystem(n);
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  Vector load = randomNumbers(n, seed);
  for (double& value : load)
    value += floats ? 0.5 : 0.2;
  DenseMatrix S1 = floats ? softChain(n) : mildStiffness(n, seed + 1, 0.8);
  system.gap = ofUnknowns(randomNumbers(n, seed + 2));
  for (double& gap : system.gap)
    gap = 0.1 * std::abs(gap);
  Vector otherLoad = randomNumbers(n, seed + 4);
  for (double& value : otherLoad)
    value *= 0.3;
  system.bodies.push_back(makeBody(all, true, std::move(S1), load, floats));
  system.bodies.push_back(makeBody(all, false, mildStiffness(n, seed + 3, 2.0), otherLoad));
  return system;
}

InterfaceSystem floatingNeumannSystem(unsigned seed)
{
  const int n = 9;
  InterfaceSystem system = emptySystem(n);
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  DenseMatrix S2 = floatingChain(n);
  for (int i = 0; i < n * n; ++i)
    S2.data()[i] *= 10.0;
  Vector load = randomNumbers(n, seed + 4);
  for (double& value : load)
    value = 0.5 * value - 0.3;
  system.gap = ofUnknowns(randomNumbers(n, seed + 2));
  for (double& gap : system.gap)
    gap = 0.3 * std::abs(gap);
  system.bodies.push_back(makeBody(all, true, mildStiffness(n, seed + 1, 0.8), randomNumbers(n, seed + 3)));
  system.bodies.push_back(makeBody(all, false, std::move(S2), std::move(load), true));
  return system;
}

InterfaceSystem sideBySide(const InterfaceSystem& first, const InterfaceSystem& second)
{
  InterfaceSystem system = emptySystem(first.size() + second.size());
  std::copy(first.gap.begin(), first.gap.end(), system.gap.begin());
  std::copy(second.gap.begin(), second.gap.end(), system.gap.begin() + first.size());
  system.bodies = first.bodies;
  for (auto body : second.bodies) {
    for (int& unknown : body.unknowns)
      unknown += first.size();
    system.bodies.push_back(std::move(body));
  }
  return system;
}

InterfaceSystem obstacleSystem(unsigned seed, bool floats)
{
  const InterfaceSystem matching = randomSystem(seed, floats);
  const int n = matching.size();
  InterfaceSystem system = emptySystem(n + 2);
  std::copy(matching.gap.begin(), matching.gap.end(), system.gap.begin() + 1);
  const Vector at = randomNumbers(2, seed + 7);
  system.isObstacle.front() = system.isObstacle.back() = 1;
  system.obstacle[0] = 0.1 * at[0];
  system.obstacle[std::size_t(n) + 1] = 0.1 * at[1];
  for (BodyTrace body : matching.bodies) {
    for (int& unknown : body.unknowns)
      ++unknown;
    if (body.roles.front() == ContactRole::Dirichlet) {
      std::vector<int> all(std::size_t(n) + 2);
      std::iota(all.begin(), all.end(), 0);
      Vector g = body.g;
      g.insert(g.begin(), at[1]);
      g.push_back(at[0]);
      body = makeBody(all, true, floats ? softChain(n + 2) : mildStiffness(n + 2, seed + 8, 0.5), g, floats);
    }
    system.bodies.push_back(std::move(body));
  }
  return system;
}

std::vector<InterfaceSystem> randomScenes(unsigned seed)
{
  // A held and a floating block on a floating bar that is pressed against both.
  InterfaceSystem chain = floatingNeumannSystem(seed);
  BodyTrace& held = chain.bodies[0];
  held = makeBody({4, 5, 6, 7, 8}, true, mildStiffness(5, seed + 5, 0.8), Vector(held.g.begin() + 4, held.g.end()));
  Vector load = randomNumbers(4, seed + 6);
  for (double& g : load)
    g = 0.5 * g + 0.5;
  chain.bodies.push_back(makeBody({3, 2, 1, 0}, true, softChain(4), load, true));
  for (double& g : chain.bodies[1].g)
    g -= 0.5;
  return {randomSystem(seed, false),
          randomSystem(seed, true),
          floatingNeumannSystem(seed),
          sideBySide(floatingNeumannSystem(seed), randomSystem(seed + 1, true)),
          chain,
          obstacleSystem(seed, false),
          obstacleSystem(seed, true)};
}

InterfaceSystem exchanged(InterfaceSystem system)
{
  for (auto& body : system.bodies) {
    for (ContactRole& role : body.roles)
      role = facing(role);
    for (double& g : body.g)
      g = -g;
    for (int i = 0; i < body.freeMotions.rows() * body.freeMotions.cols(); ++i)
      body.freeMotions.data()[i] *= -1.0;
  }
  return system;
}

InterfaceSystem inOtherUnits(InterfaceSystem system, double stiffness, double length)
{
  for (auto& body : system.bodies) {
    DenseMatrix S = *body.S->dense();
    for (int i = 0; i < S.rows() * S.cols(); ++i)
      S.data()[i] *= stiffness;
    body.S = makeDenseOperator(std::move(S));
    for (double& g : body.g)
      g *= stiffness * length;
  }
  for (UnknownValues* const lengths : {&system.gap, &system.obstacle})
    for (double& value : *lengths)
      value *= length;
  return system;
}

void expectEquilibrium(const InterfaceSystem& system, const InterfaceState& state, double tolerance)
{
  for (const auto& body : system.bodies) {
    Vector u, force;
    for (std::size_t k = 0; k < body.unknowns.size(); ++k) {
      const auto i = std::size_t(body.unknowns[k]);
      u.push_back(body.roles[k] == ContactRole::Dirichlet ? state.uDirichlet[i] : state.uNeumann[i]);
      force.push_back(body.g[k] +
                      (body.roles[k] == ContactRole::Dirichlet ? state.forceDirichlet[i] : -state.forceNeumann[i]));
    }
    const Vector Su = body.S->apply(u);
    for (std::size_t k = 0; k < u.size(); ++k)
      EXPECT_NEAR(Su[k], force[k], tolerance) << "kept dof " << k;
  }
  expectNear(system.force(state.tractionDirichlet), state.forceDirichlet, tolerance, "Dirichlet force");
  expectNear(system.force(state.tractionNeumann), state.forceNeumann, tolerance, "Neumann force");
}

void expectComplementarity(const InterfaceSystem& system, const InterfaceState& state, double tolerance)
{
  for (std::size_t i = 0; i < system.gap.size(); ++i) {
    const double opening = system.gap[i] - state.uDirichlet[i] + state.uNeumann[i];
    EXPECT_GE(opening, -tolerance);
    EXPECT_LE(state.forceDirichlet[i], tolerance);
    EXPECT_NEAR(state.closed[i] ? opening : state.forceDirichlet[i], 0.0, tolerance);
  }
}

void expectSameState(const InterfaceState& a, const InterfaceState& b, double tolerance)
{
  EXPECT_EQ(a.closed, b.closed);
  expectNear(a.uDirichlet, b.uDirichlet, tolerance, "Dirichlet displacement");
  expectNear(a.uNeumann, b.uNeumann, tolerance, "Neumann displacement");
  expectNear(a.tractionDirichlet, b.tractionDirichlet, tolerance, "Dirichlet traction");
  expectNear(a.tractionNeumann, b.tractionNeumann, tolerance, "Neumann traction");
}

Kept keepSweeps(const Coupling& coupling, const InterfaceSystem& system, int every, std::optional<SweepsDone> after,
                std::optional<double> goal)
{
  Kept kept;
  Ledger ledger;
  CouplingStart start;
  start.iterationError = goal;
  start.sweeps = {std::move(after), every, [&](const SweepsDone& done) { kept.done.push_back(done); }};
  kept.result = run(coupling, system, ledger, start);
  kept.counts = ledger.counts();
  return kept;
}

} // namespace ndframe::test
