#include "iteration_error.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

constexpr unsigned numSeeds = 12;

CouplingResult sweeps(const InterfaceSystem& system, int number, const std::string& more = {},
                      InterfaceValues traction = {})
{
  Ledger ledger;
  return run(*neumannDirichlet(1e-14, more, number), system, ledger, {std::move(traction), {}, 1e-30});
}

/// e for these contact forces of the two sides.
double errorOf(const InterfaceSystem& system, const UnknownValues& dirichletForce, const UnknownValues& neumannForce)
{
  Ledger ledger;
  const RoleSystem dirichlet = gatherRole(system, ContactRole::Dirichlet),
                   neumann = gatherRole(system, ContactRole::Neumann);
  const NeumannProblem problem(*neumann.S, neumann.g, neumann.freeMotions, ledger);
  InterfaceState state;
  state.forceDirichlet = dirichletForce;
  state.forceNeumann = neumannForce;
  state.strainedNeumann = ofUnknowns(problem.solve(neumannForce));
  return IterationError(system, dirichlet, neumann, problem, ledger).measure(state);
}

/// The role's displacement under a force, where free motions are stopped by a traction R a on the interface:
///
///   S u + C R a = force,   (C R)^T u = 0.
Vector displacement(const InterfaceSystem& system, const RoleSystem& role, const Vector& force)
{
  const int n = role.S->size(), modes = role.freeMotions.cols();
  const DenseMatrix CR = multiply(storedContactMatrix(system), role.freeMotions); // all nodes are unknowns here
  DenseMatrix bordered(n + modes, n + modes);
  for (int j = 0; j < n; ++j)
    std::copy_n(role.S->dense()->col(j), n, bordered.col(j));
  for (int m = 0; m < modes; ++m)
    for (int i = 0; i < n; ++i)
      bordered(i, n + m) = bordered(n + m, i) = CR(i, m);
  Vector rhs = force;
  rhs.resize(std::size_t(n + modes), 0.0);
  Vector u = multiply(pseudoInverse(bordered, 1e-13), rhs);
  u.resize(std::size_t(n));
  return u;
}

/// Half the distance, squared, of the role's displacements under its load and one or the other contact force.
double halfDistance(const InterfaceSystem& system, ContactRole side, const InterfaceState& state)
{
  const RoleSystem role = gatherRole(system, side);
  const double sign = signOf(side);
  Vector first = role.g, second = role.g;
  for (std::size_t i = 0; i < first.size(); ++i) {
    first[i] += sign * state.forceDirichlet[i];
    second[i] += sign * state.forceNeumann[i];
  }
  Vector u = displacement(system, role, first);
  const Vector other = displacement(system, role, second);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = 0.5 * (u[i] - other[i]);
  return dot(u, role.S->apply(u));
}

/// Both bodies with operators of the same shape, S_D = mu S_N, pressed together everywhere: one mode.
InterfaceSystem oneMode(double mu)
{
  InterfaceSystem system = emptySystem(6);
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  system.bodies.push_back(makeBody(all, true, mildStiffness(6, 3, mu), Vector(6, 50.0)));
  system.bodies.push_back(makeBody(all, false, mildStiffness(6, 3, 1.0), Vector(6, 0.0)));
  system.bodies[0].g[2] = 70.0;
  return system;
}

} // namespace

TEST(IterationError, IsHalfTheDistanceThatBackSolvesOfTheBodiesShow)
{
  for (unsigned seed = 0; seed < numSeeds; ++seed)
    for (const auto& system : randomScenes(seed))
      for (const int number : {1, 2, 4}) {
        const auto result = sweeps(system, number);
        const double expected = std::sqrt(halfDistance(system, ContactRole::Dirichlet, result.state) +
                                          halfDistance(system, ContactRole::Neumann, result.state));
        EXPECT_GT(expected, 1e-6);
        EXPECT_NEAR(*result.history.back().iterationError, expected, 1e-7 * expected);
      }
}

TEST(IterationError, VanishesWithTheIteration)
{
  for (unsigned seed = 0; seed < numSeeds; ++seed)
    for (const auto& system : randomScenes(seed)) {
      const auto history = sweeps(system, 1000).history;
      EXPECT_LT(*history.back().iterationError, 1e-13 * *history.front().iterationError);
    }
}

TEST(IterationError, ScalesWithTheUnitsOfStiffnessAndLength)
{
  for (const auto& system : randomScenes(3)) {
    const auto plain = sweeps(system, 3).history, other = sweeps(inOtherUnits(system, 1e9, 1e-3), 3).history;
    const double factor = std::sqrt(1e9) * 1e-3;
    for (std::size_t i = 0; i < plain.size(); ++i)
      EXPECT_NEAR(*other[i].iterationError, factor * *plain[i].iterationError,
                  1e-9 * factor * *plain[i].iterationError);
  }
}

TEST(IterationError, DoesNotDependOnWhichBodyIsCalledDirichlet)
{
  for (unsigned seed = 0; seed < numSeeds; ++seed)
    for (const auto& system : randomScenes(seed)) {
      if (system.isObstacle.front()) // whom only the Dirichlet body meets
        continue;
      const UnknownValues a = ofUnknowns(randomNumbers(system.size(), seed + 7)),
                          b = ofUnknowns(randomNumbers(system.size(), seed + 8));
      const double e = errorOf(system, a, b);
      EXPECT_NEAR(errorOf(exchanged(system), b, a), e, 1e-9 * e);
    }
}

TEST(IterationError, DoesNotDependOnHowTheOperatorsAreRepresented)
{
  for (const auto& stored : randomScenes(5)) {
    auto applied = stored;
    for (auto& body : applied.bodies)
      body.S = appliedOnly(*body.S->dense());
    const double e = *sweeps(stored, 2).history.back().iterationError;
    EXPECT_NEAR(*sweeps(applied, 2).history.back().iterationError, e, 1e-9 * e);
  }
}

TEST(IterationError, LeavesOutAResultantThatAFloatingBodyCannotStand)
{
  // The floating block feels only what strains it; the foundation, which is held, feels all.
  const auto system = patchSystem();
  const UnknownValues uniform = system.force(atInterface(Vector(6, -1.0))), none = ofUnknowns(Vector(6, 0.0));
  const double e = errorOf(system, uniform, none);
  // The foundation follows the pressure: S2 = C, so half the pressure stores 1/4 int 1 dS = 5/4.
  EXPECT_NEAR(e * e, 5.0 / 4.0, 1e-13);
}

TEST(IterationError, ContractsByTheFactorOfItsMode)
{
  for (const double mu : {0.3, 1.0, 2.5}) {
    const auto system = oneMode(mu);
    InterfaceValues start = run(*makeCoupling(text("Type", "Monolithic")), system).state.tractionDirichlet;
    for (double& traction : start)
      traction *= 0.9;
    for (const double theta : {0.2, 0.35, 0.5}) {
      const auto history = sweeps(system, 5, relaxation("Constant", "Theta", theta), start).history;
      const double factor = std::abs(1.0 - theta * (1.0 + mu)), first = *history.front().iterationError;
      EXPECT_GT(first, 0.1);
      for (std::size_t i = 0; i < history.size(); ++i) {
        EXPECT_EQ(history[i].open, 0);
        EXPECT_NEAR(*history[i].iterationError, std::pow(factor, double(i)) * first, 1e-10 * first);
      }
    }
  }
}

TEST(IterationError, OfThePatchHalvesFromSweepToSweep)
{
  // The mean mode of a floating Dirichlet body has mu = 0; theta is 0.5.
  const auto history = sweeps(patchSystem(), 6).history;
  for (std::size_t i = 0; i < history.size(); ++i)
    EXPECT_NEAR(*history[i].iterationError, std::sqrt(5.0 / 4.0) * std::pow(0.5, double(i)), 1e-13);
}
