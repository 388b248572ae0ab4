#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/boundary.hpp"
#include "ndframe/mesh/shape.hpp"
#include "ndframe/mesh/tetrahedron_bisection.hpp"
#include "solid_scenes.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

class TetrahedronBisectionOf : public testing::TestWithParam<Bodies>
{
protected:
  const std::vector<Mesh>& start() const { return GetParam().meshes; }
  std::vector<FacetTwin> twins() const { return findSolidTwins(start()); }
};

INSTANTIATE_TEST_SUITE_P(TetrahedronBisection, TetrahedronBisectionOf, testing::ValuesIn(solidScenes()),
                         [](const auto& scene) { return scene.param.name; });

double areaOf(const std::vector<FacetTwin>& twins, const std::vector<Mesh>& meshes)
{
  double sum = 0.0, normal[3];
  for (const FacetTwin& twin : twins)
    sum += facetNormal(meshes[std::size_t(twin.first)], twin.firstFacet, normal);
  return sum;
}

TEST_P(TetrahedronBisectionOf, StaysSoundConformingAndMatching)
{
  TetrahedronBisection bisection(start(), twins());
  const double area = areaOf(twins(), start());
  EXPECT_EQ(area > 0.0, start().size() > 1 && GetParam().name != "Wild");
  for (unsigned round = 0; round < 3; ++round) {
    bisection.refine(randomHalvings(bisection.meshes(), round));
    for (std::size_t m = 0; m < start().size(); ++m) {
      const Mesh& mesh = bisection.meshes()[m];
      EXPECT_EQ(checkMesh(mesh), std::vector<std::string>{});
      EXPECT_NEAR(volume(mesh), volume(start()[m]), 1e-12 * volume(mesh));
      // A facet with a hanging node or a crossing diagonal would have one cell on every side and count as boundary.
      EXPECT_NEAR(boundaryArea(mesh), boundaryArea(start()[m]), 1e-12 * boundaryArea(mesh));
      EXPECT_GT(mesh.numCells(), start()[m].numCells());
    }
    EXPECT_NEAR(areaOf(findSolidTwins(bisection.meshes()), bisection.meshes()), area, 1e-12 * area);
  }
}

/// Whether a point lies in the cell, up to round-off.
bool holds(const Mesh& mesh, int cell, const double* x)
{
  const double whole = cellMeasure(mesh, cell);
  for (int k = 0; k < 4; ++k) {
    Mesh part{3, {}, {0, 1, 2, 3}, {}, {}};
    for (int v = 0; v < 4; ++v) {
      const double* corner = v == k ? x : mesh.point(mesh.cell(cell)[v]);
      part.points.insert(part.points.end(), corner, corner + 3);
    }
    if (cellMeasure(part, 0) < -1e-12 * whole)
      return false;
  }
  return true;
}

TEST_P(TetrahedronBisectionOf, HalvesEveryCellAsOftenAsAskedAndPartsLieInTheirParents)
{
  std::vector<Mesh> meshes = start();
  std::mt19937 random(5);
  for (Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c)
      mesh.groups.kind.push_back(
          mesh.groups.findOrAdd(random() % 3 == 0 ? std::vector<std::string>{"core"} : std::vector<std::string>{}));
  TetrahedronBisection bisection(meshes, twins());
  for (unsigned round = 0; round < 2; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    const auto halvings = randomHalvings(before, 17 + round, 6);
    bisection.refine(halvings);
    for (std::size_t m = 0; m < before.size(); ++m) {
      const Mesh& mesh = bisection.meshes()[m];
      const std::vector<int>& parents = bisection.parents()[m];
      EXPECT_TRUE(std::is_sorted(parents.begin(), parents.end()));
      std::vector<double> volumes(std::size_t(before[m].numCells()), 0.0);
      for (int c = 0; c < mesh.numCells(); ++c) {
        const int parent = parents[std::size_t(c)];
        const double times = std::log2(cellMeasure(before[m], parent) / cellMeasure(mesh, c));
        EXPECT_NEAR(times, std::round(times), 1e-9);
        EXPECT_GE(std::lround(times), halvings[m][std::size_t(parent)]);
        for (int v = 0; v < 4; ++v)
          EXPECT_TRUE(holds(before[m], parent, mesh.point(mesh.cell(c)[v])));
        EXPECT_EQ(mesh.groups.kind[std::size_t(c)], before[m].groups.kind[std::size_t(parent)]);
        volumes[std::size_t(parent)] += cellMeasure(mesh, c);
      }
      for (int c = 0; c < before[m].numCells(); ++c)
        EXPECT_NEAR(volumes[std::size_t(c)] / cellMeasure(before[m], c), 1.0, 1e-12);
    }
  }
}

TEST_P(TetrahedronBisectionOf, PointsKeepTheirNumbersAndNewOnesAreMiddles)
{
  TetrahedronBisection bisection(start(), twins());
  for (unsigned round = 0; round < 2; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    bisection.refine(randomHalvings(before, 100 + round, 2));
    for (std::size_t m = 0; m < before.size(); ++m) {
      EXPECT_TRUE(std::equal(before[m].points.begin(), before[m].points.end(), bisection.meshes()[m].points.begin()));
      std::set<std::array<double, 3>> middles;
      for (const auto& mesh : {before[m], bisection.meshes()[m]}) // a half may be halved at once
        for (int c = 0; c < mesh.numCells(); ++c)
          for (int a = 0; a < 4; ++a)
            for (int b = 0; b < a; ++b) {
              const double *p = mesh.point(mesh.cell(c)[a]), *q = mesh.point(mesh.cell(c)[b]);
              middles.insert({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
            }
      int known = 0, added = 0;
      for (int p = before[m].numPoints(); p < bisection.meshes()[m].numPoints(); ++p, ++added) {
        const double* x = bisection.meshes()[m].point(p);
        known += int(middles.count({x[0], x[1], x[2]}));
      }
      EXPECT_GT(known, added / 2);
    }
  }
}

TEST_P(TetrahedronBisectionOf, NothingAskedIsNothingChanged)
{
  TetrahedronBisection bisection(start(), twins());
  bisection.refine(sameHalvings(start(), 0));
  for (std::size_t m = 0; m < start().size(); ++m) {
    EXPECT_EQ(bisection.meshes()[m].notes, start()[m].notes);
    expectSameMesh(bisection.meshes()[m], start()[m]);
    std::vector<int> itself(std::size_t(start()[m].numCells()));
    std::iota(itself.begin(), itself.end(), 0);
    EXPECT_EQ(bisection.parents()[m], itself);
  }
}

/// The number of the side's facet in which the facet lies; -1 for none.
int parentFacet(const Side& parents, const Mesh& before, const Mesh& mesh, Facet facet)
{
  int corners[3];
  facetVertices(mesh, facet, corners);
  for (std::size_t f = 0; f < parents.facets.size(); ++f) {
    double normal[3];
    const auto centre = facetCentre(before, parents.facets[f]);
    facetNormal(before, parents.facets[f], normal);
    const auto isIn = [&](int v) {
      const double* x = mesh.point(v);
      double off = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        off += normal[k] * (x[k] - centre[k]);
      return std::abs(off) < 1e-9 && holds(before, parents.facets[f].cell, x);
    };
    if (std::all_of(corners, corners + 3, isIn))
      return int(f);
  }
  return -1;
}

TEST_P(TetrahedronBisectionOf, SidesConsistOfThePartsOfTheirFacetsInTheirOrder)
{
  TetrahedronBisection bisection(start(), twins());
  for (unsigned round = 0; round < 2; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    bisection.refine(randomHalvings(before, 200 + round, 4));
    for (std::size_t m = 0; m < before.size(); ++m) {
      const Mesh& mesh = bisection.meshes()[m];
      ASSERT_EQ(mesh.sides.size(), before[m].sides.size());
      for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
        EXPECT_EQ(mesh.sides[s].name, before[m].sides[s].name);
        const double area = measure(before[m], before[m].sides[s]);
        EXPECT_NEAR(measure(mesh, mesh.sides[s]), area, 1e-12 * area);
        int last = 0;
        for (const Facet facet : mesh.sides[s].facets) {
          const int now = parentFacet(before[m].sides[s], before[m], mesh, facet);
          EXPECT_GE(now, last);
          last = now;
        }
      }
    }
  }
}

TEST_P(TetrahedronBisectionOf, ManyHalvingsAtOnceAreManyCallsOfOne)
{
  TetrahedronBisection atOnce(start(), twins()), oneByOne(start(), twins());
  auto left = randomHalvings(start(), 5, 5);
  atOnce.refine(left);
  for (int call = 0; call < 4; ++call) {
    const std::vector<Mesh> before = oneByOne.meshes();
    auto now = left;
    for (auto& ofMesh : now)
      for (int& number : ofMesh)
        number = std::min(number, 1);
    oneByOne.refine(now);
    for (std::size_t m = 0; m < before.size(); ++m) {
      std::vector<int> ofChildren;
      for (int c = 0; c < oneByOne.meshes()[m].numCells(); ++c) {
        const int parent = oneByOne.parents()[m][std::size_t(c)];
        const double times = std::log2(cellMeasure(before[m], parent) / cellMeasure(oneByOne.meshes()[m], c));
        ofChildren.push_back(std::max(0, left[m][std::size_t(parent)] - int(std::lround(times))));
      }
      left[m] = ofChildren;
    }
  }
  for (std::size_t m = 0; m < start().size(); ++m)
    EXPECT_EQ(sortedCorners(atOnce.meshes()[m]), sortedCorners(oneByOne.meshes()[m]));
}

TEST_P(TetrahedronBisectionOf, DoesNotDependOnTheOrderOfTheBodies)
{
  const std::vector<Mesh> turned(start().rbegin(), start().rend());
  TetrahedronBisection bisection(start(), twins()), reversed(turned, findSolidTwins(turned));
  for (unsigned round = 0; round < 3; ++round) {
    auto halvings = randomHalvings(bisection.meshes(), 300 + round, 3);
    bisection.refine(halvings);
    std::reverse(halvings.begin(), halvings.end());
    reversed.refine(halvings);
    for (std::size_t m = 0; m < start().size(); ++m)
      expectSameMesh(reversed.meshes()[start().size() - 1 - m], bisection.meshes()[m]);
  }
}

/// 0, 1, ... in another order.
std::vector<int> shuffled(int size)
{
  std::vector<int> numbers(std::size_t(size), 0);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(7));
  return numbers;
}

/// The same body with other numbers of the points, the cells in another order, their vertices turned.
Mesh renumbered(const Mesh& mesh, const std::vector<int>& oldCells)
{
  constexpr int even[3][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}};
  const std::vector<int> newPoints = shuffled(mesh.numPoints());
  Mesh other{3, mesh.points, {}, {}, {}};
  for (int p = 0; p < mesh.numPoints(); ++p)
    std::copy_n(mesh.point(p), 3, other.points.begin() + 3 * newPoints[std::size_t(p)]);
  for (const int old : oldCells)
    for (const int k : even[old % 3])
      other.cells.push_back(newPoints[std::size_t(mesh.cell(old)[k])]);
  return other;
}

TEST_P(TetrahedronBisectionOf, DoesNotDependOnTheNumbering)
{
  std::vector<Mesh> others;
  const auto halvings = randomHalvings(start(), 400, 6);
  std::vector<std::vector<int>> permuted(start().size());
  for (std::size_t m = 0; m < start().size(); ++m) {
    const std::vector<int> oldCells = shuffled(start()[m].numCells());
    others.push_back(renumbered(start()[m], oldCells));
    for (const int old : oldCells)
      permuted[m].push_back(halvings[m][std::size_t(old)]);
  }
  TetrahedronBisection bisection(start(), twins()), other(others, findSolidTwins(others));
  bisection.refine(halvings);
  other.refine(permuted);
  for (std::size_t m = 0; m < start().size(); ++m)
    EXPECT_EQ(sortedCorners(other.meshes()[m]), sortedCorners(bisection.meshes()[m]));
}

double shapeOf(const Mesh& mesh, int cell)
{
  const int* v = mesh.cell(cell);
  return tetrahedronShape(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
}

/// The different shapes of the cells: what the squared edges, ascending, are of the longest one.
std::size_t numShapes(const Mesh& mesh)
{
  std::set<std::array<long, 6>> shapes;
  for (int c = 0; c < mesh.numCells(); ++c) {
    std::array<double, 6> squares{};
    std::size_t next = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) {
        const double *p = mesh.point(mesh.cell(c)[a]), *q = mesh.point(mesh.cell(c)[b]);
        squares[next++] = std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2);
      }
    std::sort(squares.begin(), squares.end());
    std::array<long, 6> shape{};
    for (std::size_t k = 0; k < 6; ++k)
      shape[k] = std::lround(1e6 * squares[k] / squares[5]);
    shapes.insert(shape);
  }
  return shapes.size();
}

TEST(TetrahedronBisectionShapes, CubesHaveThreeShapesForEver)
{
  TetrahedronBisection bisection({kuhnCubes(2)}, {});
  const double first = worstShape(bisection.meshes()[0]);
  for (unsigned round = 0; round < 4; ++round) {
    bisection.refine(randomHalvings(bisection.meshes(), round, 7));
    EXPECT_LE(numShapes(bisection.meshes()[0]), 3U);
    EXPECT_NEAR(worstShape(bisection.meshes()[0]), first, 1e-12);
  }
}

TEST(TetrahedronBisectionShapes, OfCubesThreeHalvingsEverywhereHalveTheCubes)
{
  TetrahedronBisection bisection({kuhnCubes(1)}, {});
  bisection.refine(sameHalvings(bisection.meshes(), 3));
  EXPECT_EQ(bisection.meshes()[0].numCells(), 48);
  EXPECT_EQ(numShapes(bisection.meshes()[0]), 1U);
}

double meanShape(const Mesh& mesh)
{
  double sum = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    sum += shapeOf(mesh, c);
  return sum / mesh.numCells();
}

TEST(TetrahedronBisectionShapes, StretchedCellsBecomeRounder)
{
  TetrahedronBisection bisection({readMesh(text("Type", "Box") + doubles("Lower", "0, 0, 0") +
                                           doubles("Upper", "16, 1, 1") + ints("Cells", "1, 1, 1"))},
                                 {});
  EXPECT_LT(meanShape(bisection.meshes()[0]), 0.06);
  const double worst = worstShape(bisection.meshes()[0]);
  bisection.refine(sameHalvings(bisection.meshes(), 12));
  EXPECT_GT(meanShape(bisection.meshes()[0]), 0.4);
  EXPECT_GT(worstShape(bisection.meshes()[0]), 0.7 * worst);
}

TEST(TetrahedronBisectionShapes, OfRandomTetrahedraStayAboveAThirdOfTheFirst)
{
  for (const Mesh& mesh : randomTetrahedra(11, 30)) {
    TetrahedronBisection bisection({mesh}, {});
    for (int round = 0; round < 5; ++round) {
      bisection.refine(sameHalvings(bisection.meshes(), 3));
      EXPECT_GE(worstShape(bisection.meshes()[0]), shapeOf(mesh, 0) / 3.0);
    }
  }
}

TEST(TetrahedronBisectionShapes, HalvingsTowardsAPointStayNearIt)
{
  TetrahedronBisection bisection({kuhnCubes(2)}, {});
  for (int round = 0; round < 20; ++round) {
    const Mesh& mesh = bisection.meshes()[0];
    std::vector<int> halvings(std::size_t(mesh.numCells()), 0);
    for (int c = 0; c < mesh.numCells(); ++c)
      halvings[std::size_t(c)] = std::count(mesh.cell(c), mesh.cell(c) + 4, 0) > 0;
    bisection.refine({halvings});
  }
  EXPECT_LT(bisection.meshes()[0].numCells(), 48 + 20 * 60);
}

TEST(TetrahedronBisection, RefusesTwinsThatDoNotFit)
{
  const Mesh one = kuhnCubes(1);
  Mesh above = one;
  for (std::size_t i = 2; i < above.points.size(); i += 3)
    above.points[i] += 1.0;
  const auto twins = findSolidTwins({one, above});
  ASSERT_EQ(twins.size(), 2U);
  EXPECT_NO_THROW(TetrahedronBisection({one, above}, twins));
  const FacetTwin twin = twins[0];
  EXPECT_THROW(TetrahedronBisection({one, one}, {{0, twin.firstFacet, 1, twin.firstFacet}}),
               InternalError); // the same side of a plane
  EXPECT_THROW(TetrahedronBisection({one, above}, {{0, twin.firstFacet, 1, twins[1].secondFacet}}),
               InternalError);                                                // elsewhere
  EXPECT_THROW(TetrahedronBisection({one}, {}).refine({{1}}), InternalError); // one number for six cells
}

} // namespace
