#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "flow_settler.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/wrench_flow.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{
namespace
{

std::vector<ForceMoment> noise(const WrenchFlow& flow, int cells)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<ForceMoment> lacks(std::size_t(cells), ForceMoment{});
  ForceMoment total{};
  for (int cell = 1; cell < cells; ++cell) {
    for (double& value : lacks[std::size_t(cell)])
      value = number(random);
    addMoved(lacks[std::size_t(cell)], flow.centre(cell), flow.centre(0), total);
  }
  for (std::size_t i = 0; i < total.size(); ++i)
    lacks[0][i] = -total[i];
  return lacks;
}

} // namespace

TEST(WrenchFlow, GivesEveryCellWhatItLacks)
{
  const Mesh mesh = test::sampleMesh(3, 35.0);
  const WrenchFlow flow(mesh);
  ASSERT_EQ(flow.numParts(), 1);
  const std::vector<ForceMoment> lacks = noise(flow, mesh.numCells()), through = flow.through(lacks);
  std::vector<ForceMoment> left = lacks;
  for (std::size_t f = 0; f < through.size(); ++f)
    for (std::size_t side = 0; side < 2; ++side) {
      ForceMoment given = through[f];
      if (side == 0)
        for (double& value : given)
          value = -value;
      const int cell = flow.faces()[f].half[side] / 4;
      addMoved(given, flow.faces()[f].centre, flow.centre(cell), left[std::size_t(cell)]);
    }
  for (const ForceMoment& wrench : left)
    for (const double value : wrench)
      EXPECT_NEAR(value, 0.0, 1e-11);
}

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
      const auto recovery = test::makeRecovery("Global", {{"Degree", 2}, {"Steps", 10}});
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
