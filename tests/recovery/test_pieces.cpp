// Cells of solids that several ranks share: what each holds, and that the answer is that of one process.

#include <numeric>

#include <gmock/gmock.h>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "fem/sample_meshes.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/equilibrium/settle_balance.hpp"
#include "ndframe/equilibrium/solid_energies.hpp"
#include "ndframe/recovery/scene_pieces.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{
namespace
{

constexpr double same = 1e-14;

test::Problem sampleProblem(const Mesh& mesh, const std::string& kind)
{
  return test::solved(test::makeBody(mesh, 2, test::conditions(3, kind)), 2);
}

SceneStress recovered(const StressRecovery& recovery, const test::Problem& problem, const Comm& comm, Ledger& ledger)
{
  const RecoveryScene scene{{&problem.body}, {problem.data}, {}};
  SceneField field;
  field.displacement = {&problem.displacement};
  return recovery.recover(scene, {field}, comm, ledger)[0];
}

SceneStress recovered(const test::Problem& problem, const Comm& comm, Ledger& ledger)
{
  return recovered(*test::withSteps(2, 10), problem, comm, ledger);
}

StressCorrection whole(SceneStress stress)
{
  if (stress.pieces)
    gatherPieces(*stress.pieces, stress.corrections, test::comm());
  return stress.corrections[0];
}

double energy(const test::Problem& problem, const StressCorrection& correction)
{
  std::vector<int> cells(std::size_t(problem.body.mesh.numCells()));
  std::iota(cells.begin(), cells.end(), 0);
  const Vector energies = solidEnergies(problem.body, nullptr, correction, cells);
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

/// Cells of several shapes, few of them equal, and cells that are all equal but for six shapes.
std::vector<Mesh> sampleMeshes()
{
  return {test::renumbered(test::sampleMesh(3, 35.0), 4), test::box({4, 3, 3}, "Right", 35.0)};
}

/// Off by up to `size` of the largest, the same on all ranks.
void disturb(Vector& values, double size)
{
  test::Random random(7);
  const double scale = test::largest(values);
  for (double& value : values)
    value += size * scale * random();
}

/// A piece's part of what all ranks have.
StressCorrection heldPart(const BodyPiece& piece, const StressCorrection& all)
{
  StressCorrection part = all;
  const auto cells = std::size_t(piece.body->mesh.numCells());
  for (Vector StressCorrection::*values : {&StressCorrection::tractions, &StressCorrection::loads}) {
    const std::size_t size = (all.*values).size() / cells;
    (part.*values).clear();
    for (const int cell : piece.cells)
      for (std::size_t i = 0; i < size; ++i)
        (part.*values).push_back((all.*values)[std::size_t(cell) * size + i]);
  }
  return part;
}

} // namespace

TEST(Pieces, EveryCellHasOneOwnerAndRanksHaveAsManyCellsEach)
{
  for (const Mesh& mesh : sampleMeshes()) {
    const auto problem = sampleProblem(mesh, "clamped");
    const auto pieces = cutScene({{&problem.body}, {problem.data}, {}}, true, test::comm());
    const BodyPiece& piece = *pieces->bodies[0];
    const auto own = std::int64_t(piece.ownCells().size());
    EXPECT_EQ(test::comm().sum(own), mesh.numCells());
    EXPECT_LE(std::abs(own - mesh.numCells() / test::comm().size()), 1);
    std::vector<char> isNear(std::size_t(mesh.numPoints()), 0);
    for (const int cell : piece.ownCells())
      for (int i = 0; i < 4; ++i)
        isNear[std::size_t(mesh.cell(piece.cells[std::size_t(cell)])[i])] = 1;
    for (int cell = 0; cell < mesh.numCells(); ++cell) {
      const bool isHeld = std::any_of(mesh.cell(cell), mesh.cell(cell) + 4, [&](int v) { return isNear[v] != 0; });
      EXPECT_EQ(piece.local(cell) >= 0, isHeld) << cell;
    }
  }
}

TEST(Pieces, AnswerIsThatOfOneProcess)
{
  for (const Mesh& mesh : sampleMeshes())
    for (const std::string& kind : test::conditionKinds()) {
      const auto problem = sampleProblem(mesh, kind);
      Ledger alone, together;
      const StressCorrection expected = recovered(problem, Comm::single(), alone).corrections[0],
                             found = whole(recovered(problem, test::comm(), together));
      // Steps are in single precision, but what ranks add in another order is rounded once: measured 6e-16 and 0.
      const double size = test::largest(expected.tractions);
      EXPECT_LT(test::largest(test::difference(found.tractions, expected.tractions)), same * size) << kind;
      EXPECT_NEAR(energy(problem, found), energy(problem, expected), same * energy(problem, expected)) << kind;
      EXPECT_LT(test::largest(test::difference(found.loads, expected.loads)), same * size) << kind;
      EXPECT_EQ(found.imbalance, expected.imbalance) << kind;
      EXPECT_EQ(found.force, expected.force) << kind;
      EXPECT_EQ(together.counted("cell matrices"), alone.counted("cell matrices")) << kind;
    }
}

TEST(Pieces, DescentsEndAfterAsManyStepsAsOnOneProcess)
{
  const auto recovery = test::makeRecovery("Global");
  for (const Mesh& mesh : sampleMeshes())
    for (const std::string& kind : test::conditionKinds()) {
      const auto problem = sampleProblem(mesh, kind);
      Ledger alone, together;
      recovered(*recovery, problem, Comm::single(), alone);
      recovered(*recovery, problem, test::comm(), together);
      EXPECT_EQ(together.counted("recovery steps"), alone.counted("recovery steps")) << kind;
      EXPECT_GT(alone.counted("recovery steps"), 5) << kind;
      EXPECT_LT(alone.counted("recovery steps"), 60) << kind;
    }
}

/// Pieces number the laws of their cells by themselves, in the order in which they come.
TEST(Pieces, OfSeveralMaterialsAgreeOnWhichCellsAreAlike)
{
  BodyModel body = test::makeBody(test::box({4, 3, 3}, "Right", 35.0), 2, test::conditions(3, "clamped"));
  std::vector<int> ofCell(std::size_t(body.mesh.numCells()), 0);
  for (std::size_t cell = 0; cell < ofCell.size(); ++cell)
    ofCell[cell] = int(3 * cell / ofCell.size());
  body.laws = CellLaws({test::isotropic(1.0, 0.3, "Three Dimensional"), test::isotropic(2.0, 0.3, "Three Dimensional"),
                        test::isotropic(5.0, 0.2, "Three Dimensional")},
                       ofCell);
  const auto problem = test::solved(std::move(body), 2);
  Ledger alone, together;
  const StressCorrection expected = recovered(problem, Comm::single(), alone).corrections[0],
                         found = whole(recovered(problem, test::comm(), together));
  EXPECT_NEAR(energy(problem, found), energy(problem, expected), same * energy(problem, expected));
  EXPECT_EQ(together.counted("cell matrices"), alone.counted("cell matrices"));
}

TEST(Pieces, MatricesAreSharedAndMessagesAreFew)
{
  const Mesh mesh = test::renumbered(test::sampleMesh(3, 35.0), 4); // no two cells are equal
  const auto problem = sampleProblem(mesh, "clamped");
  Ledger ledger;
  recovered(problem, test::comm(), ledger);
  const std::int64_t ranks = test::comm().size(), largest = ledger.counted("cell matrices of the largest rank");
  EXPECT_EQ(ledger.counted("cell matrices"), mesh.numCells());
  if (ranks == 1) {
    EXPECT_EQ(ledger.counted("recovery messages"), 0);
    return;
  }
  EXPECT_EQ(largest, (mesh.numCells() + ranks - 1) / ranks);
  // Blocks, the first gradient and ten steps: one message each way at most between any two ranks.
  EXPECT_LE(ledger.counted("recovery messages"), (1 + 1 + 10 * 2) * ranks * (ranks - 1));
  EXPECT_GT(ledger.counted("recovery messages"), 0);
}

TEST(Pieces, ChecksSeeWhatTheWholeCheckSees)
{
  const auto problem = sampleProblem(test::sampleMesh(3, 35.0), "rollers");
  const RecoveryScene scene{{&problem.body}, {problem.data}, {}};
  const auto pieces = cutScene(scene, true, test::comm());
  const BodyPiece& piece = *pieces->bodies[0];
  Ledger ledger;
  StressCorrection correction = recovered(problem, Comm::single(), ledger).corrections[0];
  for (const double size : {0.0, 1e-6, 1e-3}) {
    disturb(correction.tractions, size);
    disturb(correction.loads, size);
    const EquilibriumDefects all = checkEquilibrium(problem.body, problem.data, problem.field(), correction),
                             own = checkEquilibrium(piece, problem.field(), heldPart(piece, correction), test::comm());
    EXPECT_NEAR(own.divergence, all.divergence, 1e-12);
    EXPECT_NEAR(own.interior, all.interior, 1e-12);
    EXPECT_NEAR(own.jumps, all.jumps, 1e-12);
    EXPECT_NEAR(own.loads, all.loads, 1e-12);
    EXPECT_NEAR(own.scale, all.scale, 1e-12 * all.scale);
  }
}

TEST(Pieces, DisturbancesAreTakenOutOfTheBalanceOverAllRanks)
{
  for (const Mesh& mesh : sampleMeshes())
    for (const std::string& kind : test::conditionKinds()) {
      const auto problem = sampleProblem(mesh, kind);
      const auto pieces = cutScene({{&problem.body}, {problem.data}, {}}, true, test::comm());
      const BodyPiece& piece = *pieces->bodies[0];
      Ledger ledger;
      StressCorrection all = recovered(problem, Comm::single(), ledger).corrections[0];
      const double before = test::energyOf(problem.body, all);
      disturb(all.tractions, 1e-6);
      disturb(all.loads, 1e-6);
      StressCorrection own = heldPart(piece, all);
      ASSERT_GT(checkEquilibrium(piece, problem.field(), own, test::comm()).largest(), 1e-8) << kind;
      settleBalance(piece, problem.field(), own, test::comm());
      EXPECT_LT(checkEquilibrium(piece, problem.field(), own, test::comm()).largest(), 1e-12) << kind;
      piece.gather(own, test::comm());
      EXPECT_LT(checkEquilibrium(problem.body, problem.data, problem.field(), own).largest(), 1e-12) << kind;
      EXPECT_NEAR(test::energyOf(problem.body, own), before, 1e-3 * before) << kind;
    }
}

TEST(Pieces, AMeshThatTouchesItselfIsRefusedByAllRanks)
{
  Mesh mesh; // two cells that have a vertex in common
  mesh.dim = 3;
  mesh.points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
  mesh.cells = {0, 1, 2, 3, 0, 5, 4, 6};
  const BodyModel body = test::makeBody(mesh, 2);
  StaticData data;
  data.dim = 3;
  data.order = data.degree = 2;
  const Vector displacement(std::size_t(body.numDofs()), 0.0);
  SceneField field;
  field.displacement = {&displacement};
  Ledger ledger;
  std::string message;
  try {
    test::makeRecovery("Global")->recover({{&body}, {data}, {}}, {field}, test::comm(), ledger);
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, testing::HasSubstr("touches itself at the point"));
}

} // namespace ndframe
