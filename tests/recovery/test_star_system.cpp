#include <cmath>

#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "star_system.hpp"

namespace ndframe
{

namespace
{

/// A body whose side "right" carries a normal traction that may be chosen; two fields.
struct Sample
{
  test::Problem problem;
  StarBody body;

  Sample(int dim, int order, int degree)
      : problem(
            test::solved(test::makeBody(test::sampleMesh(dim, 35.0), order, test::conditions(dim, "corner")), degree)),
        body(problem.body, problem.data)
  {}

  std::vector<FieldInput> fields() const { return {problem.field(), problem.field()}; }

  /// Those facets of the star that lie on a side, along their normals.
  std::vector<ReleasedFacet> released(const Star& star, const std::string& name) const
  {
    std::vector<ReleasedFacet> list;
    const Mesh& mesh = problem.body.mesh;
    for (const Facet facet : mesh.findSide(name)->facets)
      for (const StarCell& cell : star.cells)
        if (cell.cell == facet.cell && sortedFacet(mesh, facet) != cell.apex) {
          list.push_back({facet, {}});
          facetNormal(mesh, facet, list.back().direction.data());
        }
    return list;
  }

  double energy(const Star& star, const StarFields& x, int field) const
  {
    double sum = 0.0;
    const int data = body.reference().data();
    for (std::size_t c = 0; c < star.cells.size(); ++c) {
      const Vector part(x.col(field) + int(c) * data, x.col(field) + (int(c) + 1) * data);
      sum += dot(part, multiplySymmetric(body.cellEnergy(star.cells[c]), part));
    }
    return sum;
  }
};

double largestDifference(const DenseMatrix& A, const DenseMatrix& B)
{
  double largest = 0.0;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i)
      largest = std::max(largest, std::abs(A(i, j) - B(i, j)));
  return largest;
}

} // namespace

struct StarSystems : testing::TestWithParam<test::Space>
{
  Sample sample{GetParam().dim, GetParam().order, GetParam().degree};
  StarLoads loads{sample.body, sample.fields()};
  test::Random random{8};

  template <class Check>
  void forEachStar(const Check& check)
  {
    for (int vertex = 0; vertex < sample.problem.body.mesh.numPoints(); ++vertex) {
      const Star star = sample.body.star(vertex);
      const StarSystem system(sample.body, star, sample.released(star, "right"));
      Vector forces;
      StarFields x = loads.initial(star, forces);
      system.balance(x);
      check(system, x);
    }
  }
};

TEST_P(StarSystems, RelaxingAgainChangesNothing)
{
  forEachStar([&](const StarSystem& system, StarFields x) {
    system.relax(x);
    const StarFields once = x;
    system.relax(x);
    EXPECT_LT(largestDifference(x, once), 1e-12 * test::largest(once.column(1)));
  });
}

TEST_P(StarSystems, BalancedCellsStayBalanced)
{
  forEachStar([&](const StarSystem& system, StarFields x) {
    system.relax(x);
    const StarFields once = x;
    const Vector left = system.balance(x);
    const double size = test::largest(once.column(1));
    EXPECT_LT(largestDifference(x, once), 1e-12 * size);
    EXPECT_LT(test::largest(left), 1e-12 * size);
  });
}

/// min_z |x + dx(z, dt)|^2 = dt^T H dt + 2 h^T dt + const.
TEST_P(StarSystems, EnergyIsTheCondensedQuadraticFunctionOfTheReleasedTractions)
{
  int released = 0;
  forEachStar([&](const StarSystem& system, const StarFields& x) {
    const DenseMatrix h = system.gradient(x);
    DenseMatrix dt(system.numReleased(), 2);
    const double size = test::largest(x.column(0));
    for (int i = 0; i < dt.rows(); ++i)
      dt(i, 0) = size * random();
    StarFields still = x, moved = x;
    system.relax(still);
    system.relax(moved, dt);
    const Vector first = dt.column(0);
    const double expected = sample.energy(system.star(), still, 0) + dot(first, multiply(system.stiffness(), first)) +
                            2.0 * dot(first, h.column(0));
    EXPECT_NEAR(sample.energy(system.star(), moved, 0), expected, 1e-10 * expected);
    EXPECT_LT(largestDifference(DenseMatrix(moved.column(1)), DenseMatrix(still.column(1))), 1e-14 * size);
    released += system.numReleased();
  });
  EXPECT_GT(released, 0);
}

/// What E dt = 0 allows keeps every cell in balance; another dt leaves the wrench E dt.
TEST_P(StarSystems, ConditionsTellWhichTractionsKeepTheBalance)
{
  int conditioned = 0;
  forEachStar([&](const StarSystem& system, StarFields x) {
    const DenseMatrix E = system.conditions(), allowed = nullSpace(E, 1e-9);
    const double size = test::largest(x.column(0));
    for (int j = 0; j < std::min(allowed.cols(), 3); ++j) {
      DenseMatrix dt(system.numReleased(), 2);
      std::copy_n(allowed.col(j), dt.rows(), dt.col(0));
      for (int i = 0; i < dt.rows(); ++i)
        dt(i, 0) *= size;
      StarFields moved = x;
      system.relax(moved, dt);
      EXPECT_LT(test::largest(system.balance(moved)), 1e-12 * size);
    }
    conditioned += system.numReleased() - allowed.cols();
  });
  EXPECT_GT(conditioned, 0);
}

TEST_P(StarSystems, GiveLessEnergyThanAnyOtherBalancedStressOfTheStar)
{
  forEachStar([&](const StarSystem& system, StarFields x) {
    system.relax(x);
    StarFields other = x;
    const int data = sample.body.reference().data(), facetData = sample.body.facetData();
    const double size = test::largest(x.column(0));
    for (const Spoke& spoke : system.star().spokes)
      for (int i = 0; i < facetData && !spoke.onBoundary(); ++i) {
        const double change = size * random();
        other(spoke.cell[0] * data + spoke.facet[0] * facetData + i, 0) += change;
        other(spoke.cell[1] * data + spoke.facet[1] * facetData + i, 0) -= change;
      }
    system.balance(other);
    StarFields difference = other;
    for (int i = 0; i < x.rows(); ++i)
      difference(i, 0) -= x(i, 0);
    const double least = sample.energy(system.star(), x, 0), distance = sample.energy(system.star(), difference, 0);
    EXPECT_NEAR(sample.energy(system.star(), other, 0), least + distance, 1e-11 * (least + distance)); // orthogonal
    EXPECT_GE(distance, 0.0);
  });
}

INSTANTIATE_TEST_SUITE_P(Spaces, StarSystems,
                         testing::Values(test::Space{2, 1, 1}, test::Space{2, 2, 2}, test::Space{2, 2, 3},
                                         test::Space{3, 1, 2}),
                         test::spaceName);

} // namespace ndframe
