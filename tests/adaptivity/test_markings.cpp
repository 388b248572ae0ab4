#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "components.hpp"
#include "ndframe/adaptivity/corner_exponents.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

constexpr int degree = 2;

/// A square of 2 n^2 triangles with one corner in the origin, vertex 0.
Mesh square(int n)
{
  Mesh mesh;
  mesh.dim = 2;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.points.insert(mesh.points.end(), {double(i) / n, double(j) / n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.cells.insert(mesh.cells.end(), {a, b, d, a, d, c});
    }
  return mesh;
}

/// eta_K of interpolating r^lambda, up to a constant: h^(2p+2) r^(2 lambda - 2 - 2p) with r of the cell's centre.
Vector contributionsOf(const Mesh& mesh, double lambda)
{
  Vector eta;
  for (int c = 0; c < mesh.numCells(); ++c) {
    double centre[2] = {0.0, 0.0};
    for (int v = 0; v < 3; ++v)
      for (int k = 0; k < 2; ++k)
        centre[k] += mesh.point(mesh.cell(c)[v])[k] / 3.0;
    const double squared = centre[0] * centre[0] + centre[1] * centre[1];
    eta.push_back(
        std::sqrt(std::pow(2.0 * cellMeasure(mesh, c), degree + 1) * std::pow(squared, lambda - 1.0 - degree)));
  }
  return eta;
}

double normOf(const Vector& eta)
{
  return std::sqrt(std::inner_product(eta.begin(), eta.end(), eta.begin(), 0.0));
}

/// Refines the square for the exponent `lambda`, which is learned from two meshes.
class Corner
{
public:
  explicit Corner(double lambda, const std::string& marking = "Predicted")
      : lambda_(lambda), marking_(makeMarking(marking)), meshes_(bisected(square(2))), exponents_(degree)
  {
    observe();
    meshes_ = meshes_->refined(makeMarking("Uniform")->sizes(model(), 0.0));
    observe();
  }

  double error() const { return normOf(contributionsOf(mesh(), lambda_)); }
  const Mesh& mesh() const { return meshes_->meshes().front(); }

  /// The error that its model expects of the new mesh.
  double refineTo(double target)
  {
    const ContributionModel before = model();
    meshes_ = meshes_->refined(marking_->sizes(before, target));
    observe();
    return before.errorOn(meshes_->meshes(), meshes_->ancestors());
  }

  std::int64_t cellsFor(double target) const { return marking_->cellsFor(model(), target).value(); }

private:
  ContributionModel model() const
  {
    return {meshes_->meshes(), {contributionsOf(mesh(), lambda_)}, exponents_.exponents(), degree};
  }
  void observe() { exponents_.observe({&mesh()}, {contributionsOf(mesh(), lambda_)}); }

  double lambda_;
  std::unique_ptr<Marking> marking_;
  std::unique_ptr<RefinedMeshes> meshes_;
  CornerExponents exponents_;
};

} // namespace

TEST(PredictedMarking, ComesToThePredictedErrorInOneStep)
{
  for (const double lambda : {0.75, 0.9, 1.4}) {
    Corner corner(lambda);
    const double target = 0.1 * corner.error();
    const std::int64_t cells = corner.cellsFor(target);
    const double expected = corner.refineTo(target);
    EXPECT_LE(corner.error(), 1.3 * target) << lambda;
    EXPECT_GE(corner.error(), 0.5 * target) << lambda;
    EXPECT_NEAR(expected, corner.error(), 0.2 * corner.error()) << lambda;
    EXPECT_LE(corner.mesh().numCells(), 2.5 * double(cells)) << lambda;
  }
}

TEST(PredictedMarking, ConvergesAtTheOptimalRate)
{
  // Uniform meshes have slope -0.375 for r^0.75, graded ones -1 for p = 2.
  Corner corner(0.75);
  const double start = corner.error();
  corner.refineTo(0.1 * start);
  const double error = corner.error(), cells = corner.mesh().numCells();
  corner.refineTo(0.1 * error);
  const double slope = std::log(corner.error() / error) / std::log(corner.mesh().numCells() / cells);
  EXPECT_LE(slope, -0.9);
}

TEST(PredictedMarking, LeavesMeshesAloneThatAreGoodEnough)
{
  Corner corner(0.75);
  const int cells = corner.mesh().numCells();
  corner.refineTo(1.01 * corner.error());
  EXPECT_EQ(corner.mesh().numCells(), cells);
}

TEST(PredictedMarking, SmoothCellsAreHalvedWithoutGrading)
{
  Corner smooth(3.0);
  smooth.refineTo(0.05 * smooth.error());
  double least = 1.0, largest = 0.0;
  for (int c = 0; c < smooth.mesh().numCells(); ++c) {
    least = std::min(least, cellMeasure(smooth.mesh(), c));
    largest = std::max(largest, cellMeasure(smooth.mesh(), c));
  }
  EXPECT_LE(largest, 4.0 * least);
}

TEST(DoerflerMarking, RefinesAsFewCellsAsMakeItsFraction)
{
  Corner corner(0.75, "Doerfler");
  Vector eta = contributionsOf(corner.mesh(), 0.75);
  const Mesh before = corner.mesh();
  corner.refineTo(0.0);
  EXPECT_GT(corner.mesh().numCells(), before.numCells());
  EXPECT_LT(corner.mesh().numCells(), 2 * before.numCells()) << "the cells far from the corner stay";
  double nearest = 1.0;
  for (int c = 0; c < corner.mesh().numCells(); ++c)
    nearest = std::min(nearest, cellMeasure(corner.mesh(), c));
  EXPECT_NEAR(nearest, cellMeasure(before, 0) / 4.0, 1e-15);
}

TEST(DoerflerMarking, FindsTheCornerByItself)
{
  Corner corner(0.75, "Doerfler");
  const double start = corner.error(), cells = corner.mesh().numCells();
  while (corner.error() > 0.02 * start)
    corner.refineTo(0.0);
  EXPECT_LE(std::log(corner.error() / start) / std::log(corner.mesh().numCells() / cells), -0.8);
}

TEST(UniformMarking, QuartersEveryCell)
{
  Corner corner(0.75, "Uniform");
  const int cells = corner.mesh().numCells();
  const double expected = corner.refineTo(0.0);
  EXPECT_EQ(corner.mesh().numCells(), 4 * cells);
  EXPECT_NEAR(expected, corner.error(), 0.1 * corner.error());
}
