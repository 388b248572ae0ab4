// Which cells of solids share a matrix: those whose own matrix it is, to round-off, and no others.

#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "fem/sample_meshes.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/simd/class_matrices.hpp"

namespace ndframe
{
namespace
{

constexpr int shapesOfBox = 6; ///< tetrahedra of a box's cells

BodyModel bodyOf(Mesh mesh)
{
  return test::makeBody(std::move(mesh), 1, test::conditions(3, "clamped"));
}

/// Largest difference of a cell's own matrix from the one of its class, relative to its largest entry.
double largestDifference(const StressCells& cells, const ClassMatrices& matrices, int number)
{
  const StarBody& body = cells.any();
  const CellMap map = cellMap(body.model().mesh, sortedCell(body.model().mesh, number));
  const DenseMatrix A = CellForm(body.reference(), map, body.model().laws(number)).condensed();
  double largest = 0.0, difference = 0.0;
  for (int i = 0; i < matrices.columns(); ++i)
    for (int j = 0; j < matrices.columns(); ++j) {
      double own = 0.0; // (F^-T A F^-1)_ij, vector by vector
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          own += map.inverse[std::size_t(3 * k + i % 3)] * A(i - i % 3 + k, j - j % 3 + l) *
                 map.inverse[std::size_t(3 * l + j % 3)];
      largest = std::max(largest, std::abs(own));
      const double shared = cells.classes().scale(number) * matrices.of(number)[i * matrices.columns() + j];
      difference = std::max(difference, std::abs(own - shared));
    }
  return difference / largest;
}

/// The classes of a mesh.
int numClasses(const Mesh& mesh)
{
  const BodyModel body = bodyOf(mesh);
  return CellClasses({&body}).size();
}

} // namespace

TEST(CellClasses, OfABoxAreTheShapesInOneOfItsCells)
{
  EXPECT_EQ(numClasses(test::box({5, 4, 3})), shapesOfBox);
  EXPECT_EQ(numClasses(test::box({7, 7, 7}, "Right", 33.0)), shapesOfBox) << "turned";
  EXPECT_EQ(numClasses(test::box({3, 9, 5}, "Right", 0.0, {0.7, 1.3, 0.011})), shapesOfBox) << "flat";
}

TEST(CellClasses, ShareTheirCellsOwnMatrices)
{
  for (const int degree : {1, 2})
    for (const double rotation : {0.0, 33.0}) {
      const Mesh mesh = test::moved(test::box({6, 6, 6}, "Right", rotation), [](double* point) {
        for (int i = 0; i < 3; ++i)
          point[i] *= 1e-3;
      });
      const test::Problem problem = test::solved(bodyOf(mesh), degree);
      const StarBody body(problem.body, problem.data);
      const StressCells cells({&body});
      const ClassMatrices matrices(cells);
      EXPECT_EQ(matrices.size(), shapesOfBox);
      for (int cell = 0; cell < cells.size(); cell += 17)
        EXPECT_LT(largestDifference(cells, matrices, cell), 1e-11) << "cell " << cell << ", turned by " << rotation;
    }
}

TEST(CellClasses, HaveMatricesInProportionToTheSizesOfCells)
{
  const Mesh one = test::box({4, 4, 4});
  BodyModel both = bodyOf(one); // and a box of twice the size beside it
  for (std::size_t i = 0; i < one.points.size(); ++i)
    both.mesh.points.push_back(2.0 * one.points[i] + (i % 3 == 0 ? 5.0 : 0.0));
  for (const int vertex : one.cells)
    both.mesh.cells.push_back(vertex + one.numPoints());
  const CellClasses sizes({&both});
  EXPECT_EQ(sizes.size(), shapesOfBox);
  const int cells = one.numCells();
  for (int cell = 0; cell < cells; ++cell) {
    EXPECT_EQ(sizes.of(cell), sizes.of(cells + cell));
    EXPECT_NEAR(sizes.scale(cells + cell), 0.5, 1e-14) << "twice as long, half the energy of the same forces";
  }
}

TEST(CellClasses, AreNotSharedByCellsOfSlightlyDifferentShape)
{
  for (const double amount : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Mesh mesh = test::moved(test::box({2, 2, 2}), [&](double* point) {
      if (point[0] > 0.9 && point[1] > 0.9 && point[2] > 0.9)
        point[0] += amount;
    });
    EXPECT_GT(numClasses(mesh), shapesOfBox) << amount;
  }
}

TEST(CellClasses, AreNotSharedByMaterials)
{
  BodyModel body = bodyOf(test::box({2, 2, 2}));
  const std::vector<Elasticity> laws{test::isotropic(1.0, 0.3, "Three Dimensional"),
                                     test::isotropic(2.0, 0.3, "Three Dimensional")};
  std::vector<int> ofCell(std::size_t(body.mesh.numCells()), 0);
  for (std::size_t cell = 0; cell < ofCell.size() / 2; ++cell)
    ofCell[cell] = 1;
  body.laws = CellLaws(laws, ofCell);
  EXPECT_EQ(CellClasses({&body}).size(), 2 * shapesOfBox);
  EXPECT_EQ(CellClasses({&body, nullptr, &body}).size(), 4 * shapesOfBox) << "bodies are apart";
}

TEST(CellClasses, AreCellsOfTheirOwnInAShakenMesh)
{
  const Mesh mesh = test::shaken(test::box({6, 6, 6}), 0.02, 2);
  const BodyModel body = bodyOf(mesh);
  const CellClasses classes({&body});
  int alone = 0;
  for (int number = 0; number < classes.size(); ++number)
    alone += int(classes.count(number) == 1);
  EXPECT_GT(alone, mesh.numCells() / 2);
}

} // namespace ndframe
