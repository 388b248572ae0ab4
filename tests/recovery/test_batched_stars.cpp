#include <numeric>

#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "batched_workspace.hpp"
#include "body_stars.hpp"
#include "common/test_main.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/simd/batched_stars.hpp"

namespace ndframe
{

namespace
{

/// Stars solved one by one and in batches are the same fields.
constexpr double agreement = 1e-11;
/// The same kernels with other instructions.
constexpr double roundOff = 1e-12;

struct PlaneSpace
{
  int order, degree;
};

std::vector<PlaneSpace> planeSpaces()
{
  return {{1, 1}, {1, 2}, {2, 2}, {2, 3}};
}

std::string planeSpaceName(const testing::TestParamInfo<PlaneSpace>& test)
{
  return "Order" + std::to_string(test.param.order) + "Degree" + std::to_string(test.param.degree);
}

std::vector<int> allVertices(const BodyModel& body)
{
  std::vector<int> vertices(std::size_t(body.mesh.numPoints()));
  std::iota(vertices.begin(), vertices.end(), 0);
  return vertices;
}

std::vector<StressCorrection> zeroCorrections(const test::Problem& problem, std::size_t fields)
{
  return std::vector<StressCorrection>(fields, zeroCorrection(problem.body.mesh, problem.data.degree));
}

std::vector<StressCorrection> batched(const test::Problem& problem, const std::vector<FieldInput>& fields,
                                      const BatchedKernels& kernels = *availableKernels().back())
{
  auto corrections = zeroCorrections(problem, fields.size());
  const auto left =
      BatchedStars(problem.body, problem.data, kernels).add(fields, allVertices(problem.body), corrections);
  EXPECT_TRUE(left.empty());
  return corrections;
}

std::vector<StressCorrection> general(const test::Problem& problem, const std::vector<FieldInput>& fields)
{
  Ledger ledger;
  return BodyStars(problem.body, problem.data, StarKernels::General).solve(fields, test::comm(), ledger);
}

double largestDifference(const Vector& a, const Vector& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

void expectSame(const StressCorrection& a, const StressCorrection& b, double tolerance, const std::string& what)
{
  EXPECT_LE(largestDifference(a.tractions, b.tractions), tolerance * test::largest(b.tractions)) << what;
  EXPECT_LE(largestDifference(a.loads, b.loads), tolerance * (test::largest(b.loads) + b.force)) << what;
}

} // namespace

struct BatchedStarsOf : testing::TestWithParam<PlaneSpace>
{};

TEST_P(BatchedStarsOf, AreThoseOfTheGeneralSolver)
{
  const auto [order, degree] = GetParam();
  for (const std::string& kind : test::conditionKinds())
    for (const double rotation : {0.0, 35.0}) {
      const auto problem =
          test::solved(test::makeBody(test::sampleMesh(2, rotation), order, test::conditions(2, kind)), degree);
      const auto expected = general(problem, {problem.field()});
      const auto found = batched(problem, {problem.field()});
      expectSame(found[0], expected[0], agreement, kind);
      EXPECT_LE(found[0].imbalance, roundOff * found[0].force) << kind;
    }
}

TEST_P(BatchedStarsOf, EveryCellHasItsLaw)
{
  const auto [order, degree] = GetParam();
  BodyModel body = test::makeBody(test::sampleMesh(2, 20.0), order, test::conditions(2, "corner"));
  Elasticity stiff = body.laws(0);
  for (double& entry : stiff.D)
    entry *= 50.0;
  std::vector<int> ofCell;
  for (int c = 0; c < body.mesh.numCells(); ++c)
    ofCell.push_back(c % 3 == 1 ? 1 : 0);
  body.laws = CellLaws({body.laws(0), stiff}, ofCell);
  const auto problem = test::solved(std::move(body), degree);
  const auto expected = general(problem, {problem.field()});
  for (const BatchedKernels* kernels : availableKernels())
    expectSame(batched(problem, {problem.field()}, *kernels)[0], expected[0], agreement, kernels->name);
}

TEST_P(BatchedStarsOf, AreTheSameWithAllInstructionsAndWhateverTheFieldsBesideThem)
{
  // Valences 4 to 8, numbers by chance, more stars of a valence than lanes and fewer.
  const auto [order, degree] = GetParam();
  for (const char* pattern : {"Alternating", "Crossed"}) {
    const Mesh mesh = test::renumbered(test::shaken(test::box({4, 3}, pattern), 0.03, 2), 3);
    const auto problem = test::solved(test::makeBody(mesh, order, test::conditions(2, "corner")), degree);
    const Vector second = test::interpolate(problem.body.nodes, [](const double* x, double* u) {
      u[0] = x[0] * x[1];
      u[1] = x[0] - x[1];
    });
    const FieldInput other{&second, nullptr};
    const auto expected = general(problem, {problem.field()});
    for (const BatchedKernels* kernels : availableKernels()) {
      const auto found = batched(problem, {other, problem.field(), other}, *kernels);
      expectSame(found[1], expected[0], agreement, kernels->name);
      expectSame(found[1], batched(problem, {problem.field()}, *kernels)[0], roundOff, kernels->name);
      expectSame(found[0], found[2], roundOff, kernels->name);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PlaneSpaces, BatchedStarsOf, testing::ValuesIn(planeSpaces()), planeSpaceName);

} // namespace ndframe
