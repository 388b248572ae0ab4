#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

namespace
{

const std::string bestTheta = list("Relaxation", text("Type", "Automatic"));

/// As the driver does: with the spectrum of the roles.
CouplingResult solve(const std::string& type, const InterfaceSystem& system, const std::string& more = bestTheta)
{
  Ledger ledger;
  CouplingStart start;
  if (haveRoles(system))
    start.spectrum = joinedSpectrum(roleSpectra(system, ledger));
  return run(*makeCoupling(text("Type", type) + more), system, ledger, start);
}

/// Body 1 so many times as stiff.
InterfaceSystem stiffened(InterfaceSystem system, double factor)
{
  BodyTrace& body = system.bodies.front();
  DenseMatrix S = *body.S->dense();
  for (int i = 0; i < S.rows() * S.cols(); ++i)
    S.data()[i] *= factor;
  body.S = makeDenseOperator(std::move(S));
  return system;
}

} // namespace

TEST(AutomaticCoupling, SweepsWhereSweepsContract)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto system = randomSystem(seed, false);
    const auto result = solve("Automatic", system), sweeps = solve("Neumann-Dirichlet", system);
    EXPECT_EQ(result.type, "Neumann-Dirichlet");
    EXPECT_EQ(result.reason, sweeps.reason);
    EXPECT_EQ(result.history.size(), sweeps.history.size());
    EXPECT_EQ(result.state.forceDirichlet, sweeps.state.forceDirichlet);
  }
}

TEST(AutomaticCoupling, SolvesAllBodiesTogetherWhereSweepsHardlyContract)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto system = stiffened(randomSystem(seed, true), 1e4);
    const auto result = solve("Automatic", system);
    EXPECT_EQ(result.type, "Monolithic");
    EXPECT_TRUE(result.converged);
    EXPECT_THAT(result.reason, HasSubstr("both bodies solved together, as sweeps would contract by 0.9"));
    EXPECT_EQ(result.state.forceDirichlet, solve("Monolithic", system, "").state.forceDirichlet);
  }
}

TEST(AutomaticCoupling, GoesByTheThetaOfTheDeck)
{
  const auto system = stiffened(randomSystem(1, false), 20.0);
  EXPECT_EQ(solve("Automatic", system).type, "Neumann-Dirichlet");
  EXPECT_EQ(solve("Automatic", system, relaxation("Constant", "Theta", 0.5)).type, "Monolithic"); // diverges
  EXPECT_EQ(solve("Automatic", system, relaxation("Constant", "Theta", 0.01)).type, "Monolithic");
}

TEST(AutomaticCoupling, NeedsNoRoles)
{
  auto both = randomSystem(3, false); // body 2 is Dirichlet body of one node and Neumann body of the others
  both.bodies[0].roles[0] = ContactRole::Neumann;
  both.bodies[1].roles[0] = ContactRole::Dirichlet;
  auto met = exchanged(obstacleSystem(3, false)); // the obstacles are met by the Neumann body
  for (auto& side : {0u, 10u})
    met.bodies[0].roles[side] = ContactRole::Dirichlet;
  for (const auto& system : {both, met}) {
    EXPECT_FALSE(haveRoles(system));
    const auto result = solve("Automatic", system);
    EXPECT_EQ(result.type, "Monolithic");
    EXPECT_THAT(result.reason, HasSubstr("no roles suit both bodies"));
    expectComplementarity(system, result.state);
  }
  const auto coupling = makeCoupling(text("Type", "Automatic"));
  EXPECT_FALSE(coupling->needsRoles());
  EXPECT_TRUE(makeCoupling(text("Type", "Automatic") + text("Dirichlet Body", "As Given"))->needsRoles());
  EXPECT_TRUE(makeCoupling(text("Type", "Neumann-Dirichlet"))->needsRoles());
}

TEST(AutomaticCoupling, SolvesMoreThanTwoBodiesTogether)
{
  const auto system = sideBySide(randomSystem(1, false), randomSystem(2, false));
  const auto result = solve("Automatic", system);
  EXPECT_EQ(result.type, "Monolithic");
  EXPECT_THAT(result.reason, HasSubstr("there are more than two bodies"));
  EXPECT_FALSE(makeCoupling(text("Type", "Automatic"))->sweeps(system));
  EXPECT_TRUE(makeCoupling(text("Type", "Neumann-Dirichlet"))->sweeps(system));
}
