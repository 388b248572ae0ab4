#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "admissibility/sample_problems.hpp"
#include "equilibrium/sample_stress.hpp"
#include "flow_settler.hpp"
#include "ndframe/assembly/fields.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{

/// Stresses are in equilibrium whatever displacements are, and what they then are in energy is not absurd.
TEST(FlowSettler, BringsAnyFieldIntoEquilibrium)
{
  for (const std::string& kind : test::conditionKinds()) {
    auto problem = test::solved(test::makeBody(test::sampleMesh(3, 35.0), 2, test::conditions(3, kind)), 2);
    const auto recovered = [&] {
      Ledger ledger;
      SceneField field;
      field.displacement = {&problem.displacement};
      const RecoveryScene scene{{&problem.body}, {problem.data}, {}};
      const auto recovery = test::withSteps(2, 10);
      return test::recoverWhole(*recovery, scene, {field}, ledger)[0].corrections[0];
    };
    const double before = std::sqrt(test::energyOf(problem.body, recovered()));
    const Vector solved = problem.displacement;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1e-2, 1e-2);
    const double scale = test::largest(solved);
    for (double& value : problem.displacement)
      value += scale * number(random);
    const StressCorrection correction = recovered();
    EXPECT_LT(checkEquilibrium(problem.body, problem.data, problem.field(), correction).largest(), 1e-12) << kind;
    EXPECT_LT(correction.defect(), 1e-12) << kind;
    Vector change = solved;
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] -= problem.displacement[i];
    const double moved = std::sqrt(energy(problem.body, change));
    EXPECT_LT(std::sqrt(test::energyOf(problem.body, correction)), before + 2.0 * moved) << kind;
  }
}

} // namespace ndframe
