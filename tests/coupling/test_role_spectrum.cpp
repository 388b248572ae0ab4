#include <cmath>

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/coupling/role_spectrum.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

constexpr double accuracy = 0.03; ///< of eigenvalues from a few Lanczos steps

RoleSpectrum spectrumOf(const InterfaceSystem& system)
{
  Ledger ledger;
  const auto parts = roleSpectra(system, ledger);
  EXPECT_EQ(parts.size(), 1u);
  return parts.front().spectrum;
}

/// The eigenvalues of S_D x = mu S_N x for a held Neumann body, ascending.
Vector denseSpectrum(const InterfaceSystem& system)
{
  const DenseMatrix& D = *system.bodies[0].S->dense();
  const DenseCholesky N(*system.bodies[1].S->dense());
  DenseMatrix half(D.rows(), D.cols()), whole(D.rows(), D.cols());
  for (int j = 0; j < D.cols(); ++j) {
    const Vector column = N.solveLower(D.column(j));
    std::copy(column.begin(), column.end(), half.col(j));
  }
  for (int i = 0; i < D.rows(); ++i) {
    Vector row;
    for (int j = 0; j < D.cols(); ++j)
      row.push_back(half(i, j));
    const Vector column = N.solveLower(row);
    std::copy(column.begin(), column.end(), whole.col(i));
  }
  return symmetricEigenvalues(whole);
}

InterfaceSystem twoBodies(DenseMatrix D, bool floats, DenseMatrix N)
{
  const int n = D.rows();
  InterfaceSystem system = emptySystem(n);
  std::vector<int> all;
  for (int i = 0; i < n; ++i)
    all.push_back(i);
  system.bodies.push_back(makeBody(all, true, std::move(D), Vector(std::size_t(n), 1.0), floats));
  system.bodies.push_back(makeBody(all, false, std::move(N), Vector(std::size_t(n), 0.0)));
  return system;
}

void expectSameSpectrum(const RoleSpectrum& a, const RoleSpectrum& b)
{
  EXPECT_NEAR(a.smallest / b.smallest, 1.0, 2.0 * accuracy);
  EXPECT_NEAR(a.largest / b.largest, 1.0, 2.0 * accuracy);
  EXPECT_EQ(a.dirichletFloats, b.dirichletFloats);
  EXPECT_EQ(a.neumannFloats, b.neumannFloats);
}

} // namespace

TEST(RoleSpectrum, HasTheExtremeEigenvaluesOfTheTwoStiffnesses)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto system = twoBodies(randomSpd(30, seed), false, mildStiffness(30, seed + 1, 3.0));
    const auto exact = denseSpectrum(system);
    const auto found = spectrumOf(system);
    EXPECT_NEAR(found.largest / exact.back(), 1.0, accuracy);
    EXPECT_GE(found.smallest, (1.0 - 1e-9) * exact.front());
    EXPECT_LE(found.largest, (1.0 + 1e-9) * exact.back());
  }
}

TEST(RoleSpectrum, LeavesTheFreeMotionsOut)
{
  const auto system = twoBodies(softChain(12), true, mildStiffness(12, 1, 2.0));
  const auto exact = denseSpectrum(system);
  const auto found = spectrumOf(system);
  EXPECT_NEAR(exact[0], 0.0, 1e-12);
  EXPECT_NEAR(found.smallest / exact[1], 1.0, accuracy);
  EXPECT_NEAR(found.largest / exact.back(), 1.0, accuracy);
  EXPECT_TRUE(found.dirichletFloats);
  EXPECT_FALSE(found.neumannFloats);
}

TEST(RoleSpectrum, IsInvertedWhenTheRolesAreExchanged)
{
  for (const bool floats : {false, true}) {
    const auto system =
        twoBodies(floats ? softChain(12) : mildStiffness(12, 2, 0.5), floats, mildStiffness(12, 1, 2.0));
    expectSameSpectrum(spectrumOf(exchanged(system)), spectrumOf(system).exchanged());
  }
}

TEST(RoleSpectrum, ScalesWithTheStiffnessOfTheDirichletBody)
{
  const auto one = spectrumOf(twoBodies(mildStiffness(9, 2, 1.0), false, mildStiffness(9, 1, 1.0)));
  for (const double ratio : {1e-8, 1e8}) {
    const auto other = spectrumOf(twoBodies(mildStiffness(9, 2, ratio), false, mildStiffness(9, 1, 1.0)));
    EXPECT_NEAR(other.smallest / (ratio * one.smallest), 1.0, 1e-9);
    EXPECT_NEAR(other.largest / (ratio * one.largest), 1.0, 1e-9);
  }
}

TEST(RoleSpectrum, PredictsTheContractionOfTheSweeps)
{
  for (const bool floats : {false, true}) {
    auto system = twoBodies(floats ? softChain(8) : mildStiffness(8, 2, 3.0), floats, mildStiffness(8, 1, 1.0));
    const auto spectrum = spectrumOf(system);
    const auto result = run(*neumannDirichlet(1e-10, relaxation("Constant", "Theta", spectrum.bestTheta())), system);
    ASSERT_TRUE(result.converged);
    ASSERT_EQ(result.history.back().open, 0);
    const auto last = result.history.size() - 1;
    const double observed = std::pow(result.history[last].epsTau / result.history[last - 4].epsTau, 0.25);
    EXPECT_NEAR(observed, spectrum.contraction(), 0.05);
  }
}

TEST(RoleSpectrum, IsWhatAutomaticRelaxationConvergesWithAtAnyStiffnessRatio)
{
  // Of the stiffer to the softer body: the roles that are chosen. Others may take any number of sweeps.
  for (const double ratio : {1e-6, 1e-3, 0.1, 1.0}) {
    const auto system = twoBodies(mildStiffness(8, 2, ratio), false, mildStiffness(8, 1, 1.0));
    const auto result = run(*neumannDirichlet(1e-8, list("Relaxation", text("Type", "Automatic"))), system);
    EXPECT_TRUE(result.converged) << ratio << ": " << result.reason;
    EXPECT_LE(result.history.size(), 60u) << ratio;
  }
}

TEST(RoleSpectrum, WithAGivenThetaPredictsTheFactorOfTheWorstMode)
{
  const RoleSpectrum spectrum{0.5, 3.0, false, false}, floating{0.5, 3.0, true, false};
  EXPECT_DOUBLE_EQ(spectrum.contraction(spectrum.bestTheta()), spectrum.contraction());
  EXPECT_DOUBLE_EQ(floating.contraction(floating.bestTheta()), floating.contraction());
  EXPECT_DOUBLE_EQ(spectrum.contraction(0.5), 1.0);  // |1 - 0.5 * 4|
  EXPECT_DOUBLE_EQ(spectrum.contraction(0.1), 0.85); // |1 - 0.1 * 1.5|
}

TEST(RoleSpectrum, OfAllPartsSpansThoseOfEach)
{
  std::vector<ConnectedBodies> parts{{{0, 1}, {0.5, 2.0, false, false}}, {{2, 3}, {0.1, 0.2, false, true}}};
  const RoleSpectrum all = joinedSpectrum(parts);
  EXPECT_EQ(all.smallest, 0.1);
  EXPECT_EQ(all.largest, 2.0);
  EXPECT_FALSE(all.dirichletFloats);
  EXPECT_TRUE(all.neumannFloats);
  parts[1].spectrum.largest = std::nan("");
  EXPECT_FALSE(joinedSpectrum(parts).isKnown());
}

TEST(RoleSpectrum, OfASingleNodeHeldByContactContractsAtOnce)
{
  InterfaceSystem system = emptySystem(2);
  system.nodeOfUnknown.resize(1);
  system.gap = ofUnknowns({0.0});
  system.bodies.push_back(makeBody({0}, true, DenseMatrix(1, 1), {1.0}, true));
  system.bodies.push_back(makeBody({0}, false, DenseMatrix(Vector{2.0}), {0.0}));
  const auto spectrum = spectrumOf(system);
  EXPECT_EQ(spectrum.contraction(), 0.0);
  EXPECT_EQ(spectrum.bestTheta(), 1.0);
  EXPECT_EQ(spectrum.exchanged().contraction(), 0.0);
}

TEST(RoleSpectrum, BelongsToOneConnectedPart)
{
  InterfaceSystem system = emptySystem(8);
  const auto add = [&](std::vector<int> unknowns, bool isDirichlet, double stiffness, int number) {
    system.bodies.push_back(makeBody(unknowns, isDirichlet, mildStiffness(int(unknowns.size()), 1, stiffness),
                                     Vector(unknowns.size(), 0.0)));
    system.bodies.back().body = number;
  };
  add({4, 5}, true, 1e6, 2);
  add({0, 1, 2, 3}, true, 1.0, 3);
  add({6, 7}, true, 1e6, 5);
  add({0, 1, 2, 3}, false, 1.0, 7);
  add({4, 5, 6, 7}, false, 1.0, 8);
  Ledger ledger;
  const auto parts = roleSpectra(system, ledger);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].bodies, (std::vector<int>{2, 5, 8}));
  EXPECT_EQ(parts[1].bodies, (std::vector<int>{3, 7}));
  EXPECT_GT(parts[0].spectrum.smallest, 1e5);
  EXPECT_NEAR(parts[1].spectrum.largest, 1.0, 1e-9);
}

TEST(RoleSpectrum, CostsOneFactorAndAFewSweeps)
{
  Ledger ledger;
  roleSpectra(twoBodies(mildStiffness(40, 2, 1.0), false, mildStiffness(40, 1, 1.0)), ledger);
  EXPECT_EQ(ledger.counted("interface factorisations"), 1);
  EXPECT_GE(ledger.counted("role steps"), 2);
  EXPECT_LE(ledger.counted("role steps"), 24);
}

TEST(RoleSpectrum, IsUnknownWhenAStiffnessIsLost)
{
  const DenseMatrix sound = mildStiffness(6, 2, 1.0);
  DenseMatrix singular = sound, indefinite = sound;
  for (int i = 0; i < 6; ++i)
    singular(5, i) = singular(i, 5) = 0.0;
  indefinite(2, 2) = -indefinite(2, 2);
  for (const auto& system :
       {twoBodies(sound, false, singular), twoBodies(sound, false, indefinite), twoBodies(indefinite, false, sound)})
  {
    const auto spectrum = spectrumOf(system);
    EXPECT_FALSE(spectrum.isKnown());
    EXPECT_FALSE(spectrum.exchanged().isKnown());
    EXPECT_TRUE(std::isnan(spectrum.contraction()));
  }
}
