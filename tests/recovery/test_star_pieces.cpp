#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/equilibrium/row_reduction.hpp"
#include "ndframe/equilibrium/star_flow.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

namespace
{

Mesh sample(int dim)
{
  return test::renumbered(test::shaken(test::box(std::vector<int>(std::size_t(dim), 3)), 0.05, 1), 2);
}

struct FacetKind
{
  int dim, degree;
  double thickness; ///< 1e-4: a sliver
};

/// A facet with vertex a (the first), random or nearly flat.
std::vector<std::vector<double>> sampleFacet(const FacetKind& kind, unsigned seed)
{
  test::Random random(seed);
  std::vector<std::vector<double>> vertices;
  for (int v = 0; v < kind.dim; ++v) {
    vertices.push_back(random.vector(std::size_t(kind.dim)));
    for (int i = 1; i < kind.dim; ++i)
      vertices.back()[std::size_t(i)] *= kind.thickness;
  }
  return vertices;
}

double largestDifferenceFromIdentity(const DenseMatrix& A)
{
  double largest = 0.0;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i)
      largest = std::max(largest, std::abs(A(i, j) - (i == j ? 1.0 : 0.0)));
  return largest;
}

double largestEntry(const DenseMatrix& A)
{
  return A.cols() == 0 ? 0.0
                       : std::abs(*std::max_element(A.data(), A.data() + A.rows() * A.cols(),
                                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
}

} // namespace

TEST(StarTopology, StarsHaveAllCellsOfAVertexJoinedAtTheirSpokes)
{
  for (const int dim : {2, 3}) {
    const Mesh mesh = sample(dim);
    const VertexCells around(mesh);
    std::size_t corners = 0;
    for (int vertex = 0; vertex < mesh.numPoints(); ++vertex) {
      const Star star = makeStar(mesh, around, vertex);
      corners += star.cells.size();
      std::size_t sides = 0;
      for (const Spoke& spoke : star.spokes) {
        std::array<std::set<int>, 2> vertices;
        for (std::size_t s = 0; s < (spoke.onBoundary() ? 1U : 2U); ++s, ++sides) {
          const StarCell& cell = star.cells[std::size_t(spoke.cell[s])];
          EXPECT_NE(spoke.facet[s], cell.apex);
          for (int v = 0; v <= dim; ++v)
            if (v != spoke.facet[s])
              vertices[s].insert(cell.sorted.vertices[std::size_t(v)]);
          EXPECT_EQ(vertices[s].count(vertex), 1U);
        }
        EXPECT_TRUE(spoke.onBoundary() || vertices[0] == vertices[1]);
      }
      EXPECT_EQ(sides, star.cells.size() * std::size_t(dim));
      EXPECT_EQ(spanningTree(star).order.size(), star.cells.size());
    }
    EXPECT_EQ(corners, mesh.cells.size());
  }
}

TEST(StarTopology, ColoursAreClassesWithoutNeighbours)
{
  for (const int dim : {2, 3}) {
    const Mesh mesh = sample(dim);
    const auto classes = colourVertices(mesh, VertexCells(mesh));
    std::vector<int> colour(std::size_t(mesh.numPoints()), -1);
    for (std::size_t c = 0; c < classes.size(); ++c)
      for (const int vertex : classes[c]) {
        EXPECT_EQ(colour[std::size_t(vertex)], -1);
        colour[std::size_t(vertex)] = int(c);
      }
    EXPECT_EQ(std::count(colour.begin(), colour.end(), -1), 0);
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      for (int v = 0; v <= dim; ++v)
        for (int w = 0; w < v; ++w)
          EXPECT_NE(colour[std::size_t(mesh.cell(cell)[v])], colour[std::size_t(mesh.cell(cell)[w])]);
  }
}

TEST(StarFlow, CarriesEveryWrenchToTheFirstCell)
{
  const Mesh mesh = sample(3);
  const VertexCells around(mesh);
  const Star star = makeStar(mesh, around, mesh.cell(0)[0]);
  std::vector<DenseMatrix> needed;
  test::Random random(4);
  double total = 0.0;
  for (std::size_t c = 0; c < star.cells.size(); ++c) {
    needed.emplace_back(Vector{random()});
    total += needed.back()(0, 0);
  }
  const std::vector<DenseMatrix> given = needed;
  const SpanningTree tree = spanningTree(star);
  const auto flows = carryAlongTree(star, tree, needed);
  for (std::size_t c = 0; c < star.cells.size(); ++c) {
    double carried = 0.0;
    for (std::size_t s = 0; s < star.spokes.size(); ++s)
      for (std::size_t side = 0; side < 2; ++side)
        if (star.spokes[s].cell[side] == int(c) && flows[s].cols() > 0)
          carried += (side == 0 ? 1.0 : -1.0) * flows[s](0, 0);
    const bool isFirst = int(c) == tree.order[0];
    EXPECT_NEAR(carried, given[c](0, 0) - (isFirst ? total : 0.0), 1e-14);
    EXPECT_NEAR(needed[c](0, 0), isFirst ? total : 0.0, 1e-14);
  }
}

struct FacetSplits : testing::TestWithParam<FacetKind>
{
  FacetKind kind = GetParam();
  MomentBasis basis = facetBasis(kind.dim, kind.degree);
  std::vector<std::vector<double>> vertices = sampleFacet(kind, 7);
  std::vector<const double*> points;
  static constexpr double size = 0.7;

  void SetUp() override
  {
    for (const auto& vertex : vertices)
      points.push_back(vertex.data());
  }
  Vector arms() const { return momentArms(meanCoordinates(basis), points, points[0], kind.dim); }
};

TEST_P(FacetSplits, MapIsForceAndMomentOfTheTraction)
{
  const DenseMatrix map = wrenchMap(kind.dim, arms(), basis.size(), size);
  const Vector moments = test::Random(3).vector(std::size_t(basis.size() * kind.dim));
  const QuadratureRule rule = simplexRule(kind.dim - 1, kind.degree + 1);
  Vector expected(std::size_t(wrenchSize(kind.dim)), 0.0), m(std::size_t(basis.size()), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    basis.values(rule.point(q), m.data());
    std::array<double, 3> t{}, r{}; // t times the measure of the facet
    for (std::size_t i = 0; i < std::size_t(kind.dim); ++i) {
      for (std::size_t k = 0; k < m.size(); ++k)
        t[i] += moments[k * std::size_t(kind.dim) + i] * m[k];
      for (std::size_t v = 0; v < points.size(); ++v)
        r[i] += rule.point(q)[v] * (points[v][i] - points[0][i]);
      expected[i] += rule.weights[std::size_t(q)] * t[i];
    }
    const std::array<double, 3> cross = {r[1] * t[2] - r[2] * t[1], r[2] * t[0] - r[0] * t[2],
                                         r[0] * t[1] - r[1] * t[0]};
    for (std::size_t i = 0; i < (kind.dim == 2 ? 1U : 3U); ++i)
      expected[std::size_t(kind.dim) + i] += rule.weights[std::size_t(q)] * cross[kind.dim == 2 ? 2 : i] / size;
  }
  const Vector wrench = multiply(map, moments);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(wrench[i], expected[i], 1e-14);
}

TEST_P(FacetSplits, CarrierHasTheWrenchAndModesHaveNone)
{
  const FacetSplit split = splitFacet(kind.dim, arms(), basis.size(), size);
  const int data = basis.size() * kind.dim;
  EXPECT_EQ(split.modes.cols(), data - wrenchSize(kind.dim));
  const double large = largestEntry(split.carrier); // moments of a thin facet take large tractions
  EXPECT_LT(largestDifferenceFromIdentity(multiply(split.map, split.carrier)), 1e-14 * large);
  EXPECT_LT(largestEntry(multiply(split.map, split.modes)), 1e-15);
  // Modes and carrier together are a basis.
  DenseMatrix all(data, data);
  for (int j = 0; j < data; ++j)
    std::copy_n(j < split.modes.cols() ? split.modes.col(j) : split.carrier.col(j - split.modes.cols()), data,
                all.col(j));
  EXPECT_EQ(nullSpace(all, 1e-13).cols(), 0);
}

INSTANTIATE_TEST_SUITE_P(AllFacets, FacetSplits,
                         testing::Values(FacetKind{2, 1, 1.0}, FacetKind{2, 2, 1.0}, FacetKind{2, 3, 1.0},
                                         FacetKind{3, 1, 1.0}, FacetKind{3, 2, 1.0}, FacetKind{3, 1, 1e-3},
                                         FacetKind{3, 2, 1e-3}));

TEST(RowReduction, FindsTheRankAndUnitPivotColumns)
{
  test::Random random(5);
  DenseMatrix left(4, 2), right(2, 7);
  std::generate_n(left.data(), 8, [&] { return random(); });
  std::generate_n(right.data(), 14, [&] { return random(); });
  DenseMatrix A(4, 7); // rank 2 in the first five columns, the last two arbitrary
  const DenseMatrix product = multiply(left, right);
  std::copy_n(product.data(), 20, A.data());
  std::generate_n(A.col(5), 8, [&] { return random(); });
  const RowReduction reduced = reduceRows(A, 5, 1e-9);
  EXPECT_EQ(reduced.rank(), 2);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (const int pivot = reduced.pivot[std::size_t(j)]; pivot >= 0) {
        EXPECT_EQ(reduced.matrix(i, pivot), i == j ? 1.0 : 0.0);
      }
  // The solutions are the same: null vectors of the reduced rows are null vectors of A.
  const DenseMatrix null = nullSpace(reduced.matrix, 1e-9);
  EXPECT_LT(largestEntry(multiply(A, null)), 1e-13);
  EXPECT_EQ(null.cols(), nullSpace(A, 1e-9).cols());
}

TEST(RowReduction, OfNothingIsNothing)
{
  EXPECT_EQ(reduceRows(DenseMatrix(3, 3), 0, 1e-9).rank(), 0);
  EXPECT_EQ(reduceRows(DenseMatrix(3, 3), 3, 1e-9).rank(), 0);
}

} // namespace ndframe
