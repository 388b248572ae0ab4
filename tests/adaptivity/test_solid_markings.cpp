// Markings and predictions in space: around an edge, and where the solution is smooth.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "components.hpp"
#include "ndframe/adaptivity/edge_exponents.hpp"
#include "solid_edge.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

double normOf(const Vector& eta)
{
  return std::sqrt(std::inner_product(eta.begin(), eta.end(), eta.begin(), 0.0));
}

/// Refines the cube for u ~ r^lambda around its edge on the z axis, which is learned from two meshes.
class Edge
{
public:
  explicit Edge(double lambda, const std::string& marking = "Predicted")
      : lambda_(lambda), marking_(makeMarking(marking)), meshes_(bisected(cubes(2))), exponents_(solidDegree)
  {
    observe();
    meshes_ = meshes_->refined(makeMarking("Uniform")->sizes(model(), 0.0));
    observe();
  }

  double error() const { return normOf(edgeContributions(mesh(), lambda_)); }
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
    return {meshes_->meshes(),
            {edgeContributions(mesh(), lambda_)},
            exponents_.exponents(),
            solidDegree,
            exponents_.directions()};
  }
  void observe() { exponents_.observe({&mesh()}, {edgeContributions(mesh(), lambda_)}); }

  double lambda_;
  std::unique_ptr<Marking> marking_;
  std::unique_ptr<RefinedMeshes> meshes_;
  EdgeExponents exponents_;
};

} // namespace

TEST(PredictedMarkingInSpace, ComesToThePredictedErrorInOneStep)
{
  for (const double lambda : {0.55, 0.75, 0.9, 1.4}) {
    Edge edge(lambda);
    const double target = 0.35 * edge.error();
    const std::int64_t cells = edge.cellsFor(target);
    const double expected = edge.refineTo(target);
    EXPECT_LE(edge.error(), 1.3 * target) << lambda;
    EXPECT_GE(edge.error(), 0.5 * target) << lambda;
    EXPECT_NEAR(expected, edge.error(), 0.2 * edge.error()) << lambda;
    EXPECT_LE(edge.mesh().numCells(), 3.0 * double(cells)) << lambda;
    EXPECT_GE(edge.mesh().numCells(), 0.5 * double(cells)) << lambda;
  }
}

/// eta^2 of a part of a cell of the measure a is that of the cell times (a / A)^((2 lambda + 1) / 3) where both touch
/// the edge, and times (a / A)^(7 / 3) elsewhere.
TEST(PredictedMarkingInSpace, WhereMeshesAreMadeAnewTheSmallestPartsAtAnEdgeContributeWhatOthersDo)
{
  const double lambda = 0.7;
  const Mesh mesh = cubes(4);
  Vector exponents(std::size_t(mesh.numPoints()), solidDegree + 1.0);
  EdgeDirections directions{std::vector<std::array<double, 3>>(std::size_t(mesh.numPoints()))};
  for (int p = 0; p < mesh.numPoints(); ++p)
    if (mesh.point(p)[0] == 0.0 && mesh.point(p)[1] == 0.0) {
      exponents[std::size_t(p)] = lambda;
      directions[0][std::size_t(p)] = {0.0, 0.0, 1.0};
    }
  const Vector eta = edgeContributions(mesh, lambda);
  const ContributionModel model({mesh}, {eta}, {exponents}, solidDegree, directions, true);
  const SizeField sizes = makeMarking("Predicted")->sizes(model, 0.3 * normOf(eta));
  std::vector<double> left; // log2 eta^2 of the parts
  int atEdge = 0;
  for (std::size_t c = 0; c < eta.size(); ++c) {
    const ContributionModel::Cell& cell = model.cells()[0][c];
    const double smaller = sizes[0][c].leastLogMeasure - std::log2(cell.measure);
    left.push_back(cell.decay.logSquared + smaller * (cell.atPlace ? 2.0 * lambda + 1.0 : 7.0) / 3.0);
    atEdge += int(cell.atPlace);
    if (cell.atPlace) { // it is the measure at the distance of such a part, and no part is smaller however near it lies
      EXPECT_NEAR(sizes[0][c].logMeasureAt(cell.place.point), sizes[0][c].leastLogMeasure, 1e-12);
    }
  }
  EXPECT_GT(atEdge, 20);
  const auto [least, most] = std::minmax_element(left.begin(), left.end());
  EXPECT_NEAR(*least, *most, 1e-9);
}

TEST(PredictedMarkingInSpace, ConvergesFarFasterThanUniformMeshes)
{
  // Uniform meshes have slope -0.25 for r^0.75, the best ones -2/3 late and -0.55 at once.
  Edge edge(0.75), uniform(0.75, "Uniform");
  const double start = edge.error(), cells = edge.mesh().numCells();
  edge.refineTo(0.3 * start);
  edge.refineTo(0.12 * start);
  uniform.refineTo(0.0);
  EXPECT_LE(std::log(edge.error() / start) / std::log(edge.mesh().numCells() / cells), -0.45);
  EXPECT_NEAR(std::log(uniform.error() / start) / std::log(uniform.mesh().numCells() / cells), -0.25, 0.02);
}

TEST(PredictedMarkingInSpace, SmoothCellsAreHalvedWithoutGrading)
{
  Edge smooth(3.0);
  const double before = smooth.error();
  const double expected = smooth.refineTo(0.2 * before);
  EXPECT_NEAR(smooth.error(), expected, 1e-9 * before);
  EXPECT_LE(smooth.error(), 0.21 * before);
  double least = 1.0, largest = 0.0;
  for (int c = 0; c < smooth.mesh().numCells(); ++c) {
    least = std::min(least, cellMeasure(smooth.mesh(), c));
    largest = std::max(largest, cellMeasure(smooth.mesh(), c));
  }
  EXPECT_LE(largest, 8.0 * least);
}

TEST(PredictedMarkingInSpace, LeavesMeshesAloneThatAreGoodEnough)
{
  Edge edge(0.75);
  const int cells = edge.mesh().numCells();
  edge.refineTo(1.01 * edge.error());
  EXPECT_EQ(edge.mesh().numCells(), cells);
}

/// Edge vectors of a cell in the order of its vertices' numbers, in units of the longest coordinate difference.
std::array<std::int64_t, 9> orderedShape(const Mesh& mesh, int cell)
{
  std::array<int, 4> v;
  std::copy_n(mesh.cell(cell), 4, v.begin());
  std::sort(v.begin(), v.end());
  std::array<double, 9> edges;
  double longest = 0.0;
  for (std::size_t i = 0; i < 9; ++i) {
    edges[i] = mesh.point(v[i / 3 + 1])[i % 3] - mesh.point(v[0])[i % 3];
    longest = std::max(longest, std::abs(edges[i]));
  }
  std::array<std::int64_t, 9> shape;
  std::transform(edges.begin(), edges.end(), shape.begin(),
                 [&](double edge) { return std::llround(edge / longest * (1 << 20)); });
  return shape;
}

TEST(BisectionInSpace, CellsOfOneShapeHaveTheirVerticesInOneOrder)
{
  Edge edge(0.75);
  const double start = edge.error();
  for (const double fall : {0.3, 0.12}) {
    edge.refineTo(fall * start);
    std::set<std::array<std::int64_t, 9>> shapes;
    for (int c = 0; c < edge.mesh().numCells(); ++c)
      shapes.insert(orderedShape(edge.mesh(), c));
    EXPECT_GT(edge.mesh().numCells(), 10 * 72);
    EXPECT_LE(shapes.size(), 72u);
    EXPECT_TRUE(checkMesh(edge.mesh()).empty());
  }
}

TEST(DoerflerMarkingInSpace, HalvesOnce)
{
  Edge edge(0.75, "Doerfler");
  const Mesh before = edge.mesh();
  edge.refineTo(0.0);
  EXPECT_LT(edge.mesh().numCells(), 1.5 * before.numCells()) << "the cells far from the edge stay";
  double least = 1.0;
  for (int c = 0; c < edge.mesh().numCells(); ++c)
    least = std::min(least, cellMeasure(edge.mesh(), c));
  EXPECT_GE(least, cellMeasure(before, 0) / 4.0 * (1 - 1e-12)); // conformity may halve once more
}

TEST(UniformMarkingInSpace, CutsEveryCellIntoEight)
{
  Edge edge(0.75, "Uniform");
  const int cells = edge.mesh().numCells();
  const double expected = edge.refineTo(0.0);
  EXPECT_EQ(edge.mesh().numCells(), 8 * cells);
  EXPECT_NEAR(expected, edge.error(), 0.1 * edge.error());
}

TEST(PredictionInSpace, OfSmoothCellsFallsWithTheCellsAsItShould)
{
  // n halvings leave 2^(-2 p n / 3) of the square.
  for (const int degree : {1, 2}) {
    const std::vector<std::vector<CellDecay>> cells{std::vector<CellDecay>(7, CellDecay{-3.0, degree + 1.0})};
    const double total = std::sqrt(7 * std::exp2(-3.0)), left = std::exp2(-degree * 3 / 3.0);
    const Prediction prediction = predictRefinement(cells, total * left * (1.0 + 1e-9), {degree, 3});
    EXPECT_EQ(prediction.numCells, 7 * 8);
    EXPECT_NEAR(prediction.error, total * left, 1e-12);
    EXPECT_EQ(smoothHalvings(-3.0, prediction.level, {degree, 3}), 3);
  }
}

TEST(PredictionInSpace, EdgesCostTheMoreTheStrongerTheyAre)
{
  std::int64_t before = 0;
  for (const double lambda : {2.9, 1.4, 1.0, 0.75, 0.6, 0.5}) {
    const Prediction prediction = predictRefinement({{CellDecay{0.0, lambda}}}, 0.02, {2, 3});
    EXPECT_LE(prediction.error, 0.02);
    EXPECT_GT(prediction.numCells, before) << lambda;
    before = prediction.numCells;
  }
}
