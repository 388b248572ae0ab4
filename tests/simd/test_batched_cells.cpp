#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "assembly/sample_body.hpp"
#include "batched_cell_pass.hpp"
#include "batched_workspace.hpp"
#include "equilibrium/sample_stress.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"
#include "ndframe/simd/cell_distances.hpp"

namespace ndframe
{

namespace
{

constexpr double roundOff = 1e-12;
/// The nearly incompressible law's stiffness magnifies it.
constexpr double squaredRoundOff = 1e-20;

/// Any data: what does not balance is lifted alike by both.
StressCorrection randomCorrection(const BodyModel& body, int degree, unsigned seed)
{
  const ReferenceStress& reference = referenceStress(2, degree);
  const auto cells = std::size_t(body.mesh.numCells());
  StressCorrection correction;
  correction.dim = 2;
  correction.degree = degree;
  test::Random random(seed);
  correction.tractions = random.vector(cells * std::size_t(reference.tractions));
  correction.loads = random.vector(cells * std::size_t(reference.loads));
  return correction;
}

/// One cell after the other, without the kernels.
Vector oneByOne(const BodyModel& body, const StressCorrection& correction, const Vector& difference)
{
  Vector distances;
  for (int cell = 0; cell < body.mesh.numCells(); ++cell)
    distances.push_back(equilibratedStress(body, difference, correction, cell).energy(body.laws(cell)));
  return distances;
}

void expectSame(const Vector& found, const Vector& expected, double tolerance)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t cell = 0; cell < found.size(); ++cell)
    EXPECT_NEAR(found[cell] / expected[cell], 1.0, tolerance) << "cell " << cell;
}

/// Vertices numbered at random and turned inside out by sorting; their number is no multiple of any lanes.
Mesh manyCells()
{
  Mesh mesh = test::renumbered(test::sampleMesh(2, 20.0), 4);
  mesh.cells.resize(mesh.cells.size() - 3);
  return mesh;
}

struct CellSpace
{
  int order, degree;
};

std::string cellSpaceName(const testing::TestParamInfo<CellSpace>& test)
{
  return "Order" + std::to_string(test.param.order) + "Degree" + std::to_string(test.param.degree);
}

} // namespace

struct BatchedCellsOf : testing::TestWithParam<CellSpace>
{};

TEST_P(BatchedCellsOf, DistancesAreThoseOfTheCellsOneByOne)
{
  const auto [order, degree] = GetParam();
  for (const Elasticity& law : test::sampleLaws(2)) {
    const BodyModel body = test::bodyOf(manyCells(), order, law);
    const StressCorrection correction = randomCorrection(body, degree, 3);
    const Vector difference = test::Random(5).vector(std::size_t(body.numDofs())), none(difference.size(), 0.0);
    for (const BatchedKernels* kernels : availableKernels()) {
      SCOPED_TRACE(kernels->name);
      expectSame(batchedCellDistances(body, correction, &difference, *kernels), oneByOne(body, correction, difference),
                 roundOff);
      expectSame(batchedCellDistances(body, correction, nullptr, *kernels), oneByOne(body, correction, none), roundOff);
    }
  }
}

TEST_P(BatchedCellsOf, EveryCellHasItsLaw)
{
  const auto [order, degree] = GetParam();
  const auto laws = test::sampleLaws(2);
  BodyModel body = test::bodyOf(manyCells(), order, laws[0]);
  std::vector<int> ofCell;
  for (int c = 0; c < body.mesh.numCells(); ++c)
    ofCell.push_back(c * 7 % int(laws.size()));
  body.laws = CellLaws(laws, ofCell);
  const StressCorrection correction = randomCorrection(body, degree, 3);
  const Vector difference = test::Random(5).vector(std::size_t(body.numDofs()));
  for (const BatchedKernels* kernels : availableKernels())
    expectSame(batchedCellDistances(body, correction, &difference, *kernels), oneByOne(body, correction, difference),
               roundOff);
}

TEST_P(BatchedCellsOf, DistancesAreThoseThatTheCertificateTakes)
{
  const auto [order, degree] = GetParam();
  const BodyModel body = test::bodyOf(manyCells(), order, test::sampleLaws(2)[0]);
  const StressCorrection correction = randomCorrection(body, degree, 7);
  const Vector difference = test::Random(8).vector(std::size_t(body.numDofs()));
  EXPECT_EQ(cellDistances(body, correction, &difference),
            batchedCellDistances(body, correction, &difference, *availableKernels().back()));
}

TEST_P(BatchedCellsOf, DistanceVanishesWhereTheStressesCancel)
{
  // Squares of round-off, which a square that was multiplied out would not be.
  const auto [order, degree] = GetParam();
  if (order > degree)
    return;
  for (const Elasticity& law : test::sampleLaws(2)) {
    const BodyModel body = test::bodyOf(test::shuffledCell(2, 5), order, law);
    const test::ElasticField field = test::elasticField(law, order, 6);
    const StressCorrection moments = test::momentsOf(field.stress, body.mesh, degree);
    Vector difference = test::interpolate(body.nodes, field.displacement);
    const double energy = cellEnergies(body, difference)[0];
    for (double& value : difference)
      value = -value;
    for (const BatchedKernels* kernels : availableKernels())
      EXPECT_LT(batchedCellDistances(body, moments, &difference, *kernels)[0], squaredRoundOff * energy)
          << kernels->name;
  }
}

INSTANTIATE_TEST_SUITE_P(PlaneSpaces, BatchedCellsOf,
                         testing::Values(CellSpace{1, 1}, CellSpace{1, 2}, CellSpace{1, 3}, CellSpace{2, 1},
                                         CellSpace{2, 2}, CellSpace{2, 3}),
                         cellSpaceName);

TEST(BatchedCells, StressAtTheVerticesIsTheDisplacements)
{
  for (const int order : {1, 2}) {
    const Elasticity law = test::sampleLaws(2)[2];
    const BodyModel body = test::bodyOf(manyCells(), order, law);
    const test::ElasticField field = test::elasticField(law, order, 9);
    const Vector u = test::interpolate(body.nodes, field.displacement);
    for (const BatchedKernels* kernels : availableKernels()) {
      const Vector stress = vertexStress(body, *kernels, u);
      ASSERT_EQ(stress.size(), 3 * body.mesh.cells.size());
      for (std::size_t corner = 0; corner < body.mesh.cells.size(); ++corner) {
        std::vector<double> expected(3);
        field.stress(body.mesh.point(body.mesh.cells[corner]), expected.data());
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(stress[3 * corner + i], expected[i], roundOff * test::largest(stress)) << kernels->name;
      }
    }
  }
}

} // namespace ndframe
