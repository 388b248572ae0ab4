// Any number of bodies in one active set: the sparse way agrees with the dense one, and unknowns that nodes share count
// once.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "feti_problem.hpp"
#include "network_problem.hpp"
#include "network_statuses.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

struct Solution
{
  UnilateralState status;
  UnknownValues uDirichlet, uNeumann;
};

Solution solvedAsNetwork(const InterfaceSystem& system)
{
  const Network network = networkOf(system);
  Ledger ledger;
  NetworkProblem factored(network, ledger);
  Solution solution;
  CouplingStart start;
  start.closed.assign(std::size_t(system.size()), 1);
  auto [status, v] = settleNetwork(network, factored, refinedTolerance, system, start, ledger);
  solution.status = std::move(status);
  solution.uDirichlet = ofUnknowns(rowValues(network.dirichlet, network.dirichletOffset, v));
  solution.uNeumann = system.withObstacles(ofUnknowns(rowValues(network.neumann, network.neumannOffset, v)));
  return solution;
}

UnknownValues withOneMore(Vector values, double last)
{
  values.push_back(last);
  return ofUnknowns(std::move(values));
}

double largestDifference(const Vector& a, const Vector& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

class Networks : public testing::TestWithParam<int>
{};

} // namespace

TEST_P(Networks, AreSolvedAsTheDenseSystemIs)
{
  for (const InterfaceSystem& system : randomScenes(unsigned(GetParam()))) {
    const InterfaceState dense =
        run(*makeCoupling("<Parameter name='Type' type='string' value='Monolithic'/>"), system).state;
    const Solution sparse = solvedAsNetwork(system);
    EXPECT_EQ(sparse.status.closed, dense.closed);
    const double force = largestEntry(dense.forceDirichlet), u = largestEntry(dense.uDirichlet);
    EXPECT_LT(largestDifference(sparse.status.force, dense.forceDirichlet), 1e-9 * force);
    EXPECT_LT(largestDifference(sparse.uDirichlet, dense.uDirichlet), 1e-9 * u);
    EXPECT_LT(largestDifference(sparse.uNeumann, dense.uNeumann), 1e-9 * u);
  }
}

/// Of one coupling against Monolithic.
void expectSolvedAsTogether(const std::string& coupling, const InterfaceSystem& system)
{
  const auto together = run(*makeCoupling("<Parameter name='Type' type='string' value='Monolithic'/>"), system);
  const auto other = run(*makeCoupling("<Parameter name='Type' type='string' value='" + coupling + "'/>"), system);
  EXPECT_EQ(other.state.closed, together.state.closed);
  const double force = largestEntry(together.state.forceDirichlet), u = largestEntry(together.state.uDirichlet);
  EXPECT_LT(largestDifference(other.state.forceDirichlet, together.state.forceDirichlet), 1e-9 * force);
  EXPECT_LT(largestDifference(other.state.uDirichlet, together.state.uDirichlet), 1e-8 * u);
  EXPECT_LT(largestDifference(other.state.tractionNeumann, together.state.tractionNeumann),
            1e-8 * largestEntry(together.state.tractionNeumann));
  expectEquilibrium(system, other.state, 1e-8);
  expectComplementarity(system, other.state, 1e-8);
}

TEST_P(Networks, AreSolvedByFetiAsTheyAreTogether)
{
  for (const InterfaceSystem& system : randomScenes(unsigned(GetParam())))
    expectSolvedAsTogether("FETI", system);
}

TEST_P(Networks, AreSolvedByNeumannNeumannAsTheyAreTogether)
{
  for (const InterfaceSystem& system : randomScenes(unsigned(GetParam())))
    expectSolvedAsTogether("Neumann-Neumann", system);
}

/// What FETI says of its own error is never too small: the energy norm of what its displacements are wrong by, where
/// the statuses are those of the exact solution.
TEST_P(Networks, StopFetiWhereItSays)
{
  for (const InterfaceSystem& system : randomScenes(unsigned(GetParam()))) {
    const auto exact = run(*makeCoupling("<Parameter name='Type' type='string' value='Monolithic'/>"), system);
    const Network network = networkOf(system);
    Ledger ledger;
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
      FetiProblem problem(network, {tolerance}, ledger);
      if (!problem.holds(exact.state.closed))
        continue;
      StatusPass pass;
      problem.solve(exact.state.closed, 0.0, pass);
      NetworkProblem direct(network, ledger);
      StatusPass solved;
      direct.solve(exact.state.closed, 0.0, solved);
      Vector wrong = problem.displacement();
      for (std::size_t k = 0; k < wrong.size(); ++k)
        wrong[k] -= direct.displacement()[k];
      const double energy = dot(wrong, NetworkBodies(network).stiff(wrong));
      EXPECT_LT(std::sqrt(std::max(0.0, energy)), problem.error() * (1.0 + 1e-6) + 1e-12 * largestEntry(network.g));
    }
  }
}

/// An unknown that stands twice, as where two interfaces of the same bodies meet in a node: the tighter gap decides,
/// the bodies stay where they were, and the forces of both add up to the one before.
TEST_P(Networks, CountAnUnknownOnceThatStandsTwice)
{
  const InterfaceSystem system = randomSystem(unsigned(GetParam()), GetParam() % 2 == 0);
  const Solution once = solvedAsNetwork(system);
  for (int unknown = 0; unknown < system.size(); ++unknown) {
    InterfaceSystem twice = system;
    for (BodyTrace& body : twice.bodies) {
      const auto place = std::find(body.unknowns.begin(), body.unknowns.end(), unknown) - body.unknowns.begin();
      body.dependents.push_back({twice.size(), body.roles[std::size_t(place)], {{int(place), 1.0}}, 0.0});
    }
    twice.nodeOfUnknown.push_back(twice.nodeOfUnknown[std::size_t(unknown)]);
    twice.gap = withOneMore(twice.gap, twice.gap[std::size_t(unknown)] + (unknown % 2 == 0 ? 0.0 : 1.0));
    twice.isObstacle.push_back(0);
    twice.obstacle = withOneMore(twice.obstacle, 0.0);
    const Solution both = solvedAsNetwork(twice);
    Vector force = both.status.force;
    force[std::size_t(unknown)] += force.back();
    force.pop_back();
    EXPECT_LT(largestDifference(once.status.force, force), 1e-9 * largestEntry(once.status.force));
    EXPECT_LT(largestDifference(once.uDirichlet, both.uDirichlet), 1e-9 * largestEntry(once.uDirichlet));
    EXPECT_EQ(both.uDirichlet.back(), both.uDirichlet[std::size_t(unknown)]);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Networks, testing::Range(0, 12));
