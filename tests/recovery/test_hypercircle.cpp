#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "common/test_main.hpp"
#include "recovery/sample_polynomials.hpp"
#include "recovery/sample_recovery.hpp"
#include "recovery/sample_waves.hpp"

namespace ndframe
{
namespace
{

/// A stretched, uneven box; few cells in space.
Mesh mesh(int dim)
{
  if (dim == 2)
    return test::sampleMesh(2, 0.0);
  return test::moved(test::box({2, 1, 1}, "Right", 0.0, {1.5, 1.0, 0.8}), [](double* x) {
    x[1] += 0.1 * x[0];
    x[2] += 0.2 * x[0] * x[1];
  });
}

struct Recovery
{
  std::string name;
  std::vector<std::pair<std::string, double>> entries;
};

const std::vector<Recovery>& recoveries()
{
  static const std::vector<Recovery> all = {{"Star", {}}, {"Star", {{"Sweeps", 1}}}, {"Element", {}}};
  return all;
}

/// Calls `check(correction)` for every recovery that there is.
void withRecoveries(const test::Problem& problem, const std::function<void(const StressCorrection&)>& check)
{
  for (const Recovery& recovery : recoveries()) {
    auto entries = recovery.entries;
    entries.emplace_back("Degree", problem.data.degree);
    const auto component = test::makeRecovery(recovery.name, entries);
    if (!component->refusal(problem.data.dim, problem.data.order, false).empty())
      continue;
    SCOPED_TRACE(recovery.name + (recovery.entries.empty() ? "" : " with a sweep"));
    Ledger ledger;
    const auto stresses = test::recoverWhole(*component, {{&problem.body}, {problem.data}, {}},
                                             {{{&problem.displacement}, {}, false, {}}}, ledger);
    check(stresses[0].corrections[0]);
  }
}

/// Orthotropic; in the plane also isotropic and nearly incompressible.
std::vector<Elasticity> lawsOf(int dim)
{
  const auto laws = test::sampleLaws(dim);
  return dim == 2 ? std::vector<Elasticity>{laws[2], laws[0], laws[1]} : std::vector<Elasticity>{laws[2]};
}

test::ExactSolution polynomialSolution(int degree, const Elasticity& law)
{
  const auto field = test::exactField(law.dim, degree, law, 3);
  test::ExactSolution exact;
  exact.dim = law.dim;
  exact.stress = [field, strains = law.strains()](const double* x, double* sigma) {
    for (int s = 0; s < strains; ++s)
      sigma[s] = field.stress[std::size_t(s)](x, field.dim);
  };
  constexpr int inSpace[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  for (int s = 0; s < law.strains(); ++s)
    exact.stressFunctions.push_back(test::functionOf(field.stress[std::size_t(s)].text()));
  for (int i = 0; i < law.dim; ++i) {
    test::Polynomial force;
    for (int j = 0; j < law.dim; ++j)
      force.add(-1.0, field.stress[std::size_t(law.dim == 2 && i != j ? 2 : inSpace[i][j])].derivative(j));
    exact.forceFunctions.push_back(test::functionOf(force.text()));
  }
  return exact;
}

} // namespace

struct Hypercircles : testing::TestWithParam<test::Space>
{};

/// |sigma - sigma^|^2 + |u - u_h|^2 = D^2 = |sigma^ - K eps(u_h)|^2 for loads that the recovered stress carries
/// exactly, and |sigma - (sigma^ + K eps(u_h)) / 2| = D / 2.
TEST_P(Hypercircles, AreEqualitiesForPolynomialLoads)
{
  const auto [dim, order, degree] = GetParam();
  for (const Elasticity& law : lawsOf(dim)) {
    SCOPED_TRACE(law(0, 0) / law(2, 2));
    const auto exact = polynomialSolution(order + 1, law);
    const auto problem = test::solvedUnder(exact, mesh(dim), order, degree, law);
    EXPECT_EQ(test::largest(problem.data.oscillation), 0.0);
    withRecoveries(problem, [&](const StressCorrection& correction) {
      const double square = test::energyOf(problem.body, correction);
      const auto distance = test::distances(exact, problem, correction);
      EXPECT_NEAR(distance.computed + distance.equilibrated, square, 1e-10 * square);
      EXPECT_NEAR(distance.mean, square / 4.0, 1e-10 * square);
      if (law(0, 0) < 100.0 * law(2, 2)) { // nearly incompressible ones are bounded less sharply
        EXPECT_LT(std::sqrt(square), 4.0 * std::sqrt(distance.computed));
      }
    });
  }
}

/// Loads that are no polynomials: what the recovered stress does not carry is bounded by the oscillation.
TEST_P(Hypercircles, HoldUpToTheOscillationOfOtherLoads)
{
  const auto [dim, order, degree] = GetParam();
  for (const double waves : dim == 2 ? Vector{0.1, 0.5, 1.5} : Vector{0.02})
  { // shorter ones are cut too often in space
    SCOPED_TRACE(waves);
    const Elasticity law = lawsOf(dim).front();
    const auto exact = test::waveSolution(law, waves, 5);
    const auto problem = test::solvedUnder(exact, mesh(dim), order, degree, law);
    const double oscillation =
        std::sqrt(std::accumulate(problem.data.oscillation.begin(), problem.data.oscillation.end(), 0.0));
    EXPECT_GT(oscillation, 0.0);
    withRecoveries(problem, [&](const StressCorrection& correction) {
      const double square = test::energyOf(problem.body, correction), distance = std::sqrt(square);
      const auto exactly = test::distances(exact, problem, correction);
      EXPECT_LE(std::sqrt(exactly.computed), distance + oscillation);
      EXPECT_LE(std::sqrt(exactly.equilibrated), distance + oscillation);
      EXPECT_LE(std::sqrt(exactly.mean), distance / 2.0 + oscillation);
      // The work of the loads' oscillation in the error: what the equality lacks.
      const double work = (exactly.computed + exactly.equilibrated - square) / 2.0;
      EXPECT_LE(std::abs(work), oscillation * std::sqrt(exactly.computed));
    });
  }
}

INSTANTIATE_TEST_SUITE_P(AllSpaces, Hypercircles, testing::ValuesIn(test::allSpaces()), test::spaceName);

} // namespace ndframe
