#include <gtest/gtest.h>

#include "body_stars.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"
#include "recovery/sample_polynomials.hpp"

namespace ndframe
{

struct Hypercircle : testing::TestWithParam<test::Space>
{};

/// |sigma - sigma^|^2 + |u - u_h|^2 = |sigma^ - K eps(u_h)|^2 for loads that the recovered stress carries exactly.
TEST_P(Hypercircle, IsAnEquality)
{
  const auto [dim, order, degree] = GetParam();
  const Elasticity law = test::sampleLaws(dim)[2];
  // The stress of the solution has the degree that tractions may have, its divergence that of the loads.
  const auto exact = test::exactField(dim, order + 1, law, 3);
  BodyModel body = test::makeBody(test::sampleMesh(dim, 0.0), order, test::loadsOf(exact));
  body.laws = law;
  const test::Problem problem = test::solved(std::move(body), degree);
  EXPECT_EQ(test::largest(problem.data.oscillation), 0.0);
  Ledger ledger;
  const auto correction = BodyStars(problem.body, problem.data).solve({problem.field()}, test::comm(), ledger)[0];
  const auto distanceTo = [&](const StressCorrection& added) {
    std::vector<SplitStress> cells;
    for (int cell = 0; cell < problem.body.mesh.numCells(); ++cell)
      cells.push_back(equilibratedStress(problem.body, problem.displacement, added, cell));
    return test::distance(exact, problem.body, [&](int cell, int sub, const double* lambda, double* sigma) {
      cells[std::size_t(cell)].stress(sub, lambda, sigma);
    });
  };
  StressCorrection none = correction;
  none.tractions.assign(none.tractions.size(), 0.0);
  none.loads.assign(none.loads.size(), 0.0);
  const double bound = test::energyOf(problem.body, correction);
  EXPECT_NEAR(distanceTo(correction) + distanceTo(none), bound, 1e-11 * bound);
  EXPECT_GT(distanceTo(none), 0.1 * bound);
}

INSTANTIATE_TEST_SUITE_P(AllSpaces, Hypercircle, testing::ValuesIn(test::allSpaces()), test::spaceName);

} // namespace ndframe
