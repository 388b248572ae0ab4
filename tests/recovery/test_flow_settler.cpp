#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "admissibility/sample_problems.hpp"
#include "block_flow.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "fem/sample_meshes.hpp"
#include "flow_settler.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/recovery/scene_pieces.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{
namespace
{

std::vector<ForceMoment> noise(const BlockFlow& flow, int cells)
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

/// What cells lack when they have been given what passes through their half facets.
std::vector<ForceMoment> left(const Mesh& mesh, const BlockFlow& flow, std::vector<ForceMoment> lacks,
                              const std::vector<ForceMoment>& through)
{
  for (std::size_t half = 0; half < through.size(); ++half) {
    const std::size_t cell = half / 4;
    const Facet facet{int(cell), sortedCell(mesh, int(cell)).local[half % 4]};
    ForceMoment given = through[half];
    for (double& value : given)
      value = -value;
    addMoved(given, facetCentre(mesh, facet), flow.centre(int(cell)), lacks[cell]);
  }
  return lacks;
}

double largest(const std::vector<ForceMoment>& wrenches)
{
  double value = 0.0;
  for (const ForceMoment& wrench : wrenches)
    for (const double entry : wrench)
      value = std::max(value, std::abs(entry));
  return value;
}

} // namespace

TEST(BlockFlow, GivesEveryCellWhatItLacks)
{
  for (const Mesh& mesh : {test::sampleMesh(3, 35.0), test::box({9, 8, 7}, "Right", 35.0)}) { // one box, several
    const BlockFlow flow(mesh, nullptr, Comm::single());
    ASSERT_EQ(flow.numParts(), 1);
    const std::vector<ForceMoment> lacks = noise(flow, mesh.numCells());
    EXPECT_LT(largest(left(mesh, flow, lacks, flow.through(lacks))), 1e-10);
  }
}

/// However the ranks share the cells, what passes through faces is the same but for round-off.
TEST(BlockFlow, IsThatOfOneProcess)
{
  const Mesh mesh = test::renumbered(test::box({9, 8, 7}, "Right", 35.0), 4);
  const BodyModel body = test::makeBody(mesh, 2, test::conditions(3, "clamped"));
  const auto pieces =
      cutScene({{&body}, {makeStaticData(body, 2, {}, OscillationBound::ByConstants)}, {}}, true, test::comm());
  const BodyPiece& piece = *pieces->bodies[0];
  const BlockFlow alone(mesh, nullptr, Comm::single()), together(piece.model.mesh, &piece, test::comm());
  const std::vector<ForceMoment> lacks = noise(alone, mesh.numCells()), expected = alone.through(lacks);
  std::vector<ForceMoment> own;
  for (std::size_t cell = 0; cell < piece.cells.size(); ++cell)
    own.push_back(piece.owns(int(cell)) ? lacks[std::size_t(piece.cells[cell])] : ForceMoment{});
  const std::vector<ForceMoment> found = together.through(own);
  std::vector<ForceMoment> difference;
  for (std::size_t cell = 0; cell < piece.cells.size(); ++cell)
    for (std::size_t facet = 0; facet < 4; ++facet) {
      difference.push_back(found[4 * cell + facet]);
      for (std::size_t i = 0; i < 6 && piece.owns(int(cell)); ++i)
        difference.back()[i] -= expected[4 * std::size_t(piece.cells[cell]) + facet][i];
    }
  EXPECT_LT(largest(difference), 1e-10 * largest(expected));
  EXPECT_EQ(together.numParts(), 1);
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
