#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "bisection_scenes.hpp"
#include "meshing/mesh_deck.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/outline.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

class BisectionOf : public testing::TestWithParam<Bodies>
{
protected:
  const std::vector<Mesh>& start() const { return GetParam().meshes; }
  std::vector<FacetTwin> twins() const { return findTwins(start()); }
};

INSTANTIATE_TEST_SUITE_P(Bisection, BisectionOf, testing::ValuesIn(bisectionScenes()),
                         [](const auto& scene) { return scene.param.name; });

class BisectionOfSquares : public BisectionOf
{};

INSTANTIATE_TEST_SUITE_P(Bisection, BisectionOfSquares, testing::ValuesIn(squareScenes()),
                         [](const auto& scene) { return scene.param.name; });

/// Whether the middle of a cell of another mesh lies inside a cell of this one.
bool holdsMiddle(const Mesh& mesh, int cell, const Mesh& other, int otherCell)
{
  double x[6], y[6];
  cellPoints(mesh, cell, x);
  cellPoints(other, otherCell, y);
  const double px = (y[0] + y[2] + y[4]) / 3, py = (y[1] + y[3] + y[5]) / 3;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const double *a = x + 2 * k, *b = x + 2 * ((k + 1) % 3);
    inside = inside && (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]) > 0;
  }
  return inside;
}

TEST_P(BisectionOf, StaysSoundConformingAndMatching)
{
  Bisection bisection(start(), twins());
  const double length = lengthOf(twins(), start());
  EXPECT_EQ(length > 0.0, start().size() > 1);
  for (unsigned round = 0; round < 4; ++round) {
    bisection.refine(randomHalvings(bisection.meshes(), round));
    for (std::size_t m = 0; m < start().size(); ++m) {
      const Mesh& mesh = bisection.meshes()[m];
      EXPECT_EQ(checkMesh(mesh), std::vector<std::string>{});
      EXPECT_NEAR(volume(mesh), volume(start()[m]), 1e-13 * volume(mesh));
      // An edge with a hanging node would have one cell on every side of it and count as boundary.
      EXPECT_NEAR(boundaryLength(mesh), boundaryLength(start()[m]), 1e-12 * boundaryLength(mesh));
      EXPECT_GT(mesh.numCells(), start()[m].numCells());
    }
    EXPECT_NEAR(lengthOf(findTwins(bisection.meshes()), bisection.meshes()), length, 1e-12 * length);
  }
}

TEST_P(BisectionOf, GroupsOfCellsKeepTheirPlaces)
{
  std::vector<Mesh> meshes = start();
  std::mt19937 random(5);
  for (Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c)
      mesh.groups.kind.push_back(
          mesh.groups.findOrAdd(random() % 3 == 0 ? std::vector<std::string>{"core"} : std::vector<std::string>{}));
  Bisection bisection(meshes, twins());
  for (unsigned round = 0; round < 3; ++round) {
    bisection.refine(randomHalvings(bisection.meshes(), 40 + round));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      EXPECT_TRUE(sameOutline(outlineOf(bisection.meshes()[m]), outlineOf(meshes[m])));
      for (int c = 0; c < bisection.meshes()[m].numCells(); ++c)
        for (int k = 0; k < meshes[m].numCells(); ++k)
          if (holdsMiddle(meshes[m], k, bisection.meshes()[m], c)) {
            EXPECT_EQ(bisection.meshes()[m].groups.kind[std::size_t(c)], meshes[m].groups.kind[std::size_t(k)]);
          }
    }
  }
}

TEST_P(BisectionOfSquares, HalvesEveryCellAsOftenAsAskedAndPartsLieInTheirParents)
{
  Bisection bisection(start(), twins());
  for (unsigned round = 0; round < 3; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    const auto halvings = randomHalvings(before, 17 + round, 7);
    bisection.refine(halvings);
    for (std::size_t m = 0; m < before.size(); ++m) {
      const Mesh& mesh = bisection.meshes()[m];
      std::vector<double> areas(std::size_t(before[m].numCells()), 0.0);
      for (int c = 0; c < mesh.numCells(); ++c) {
        const int parent = bisection.parents()[m][std::size_t(c)];
        const double times = std::log2(cellMeasure(before[m], parent) / cellMeasure(mesh, c));
        EXPECT_NEAR(times, std::round(times), 1e-9);
        EXPECT_GE(std::lround(times), halvings[m][std::size_t(parent)]);
        EXPECT_TRUE(holdsMiddle(before[m], parent, mesh, c));
        areas[std::size_t(parent)] += cellMeasure(mesh, c);
      }
      for (int c = 0; c < before[m].numCells(); ++c)
        EXPECT_NEAR(areas[std::size_t(c)] / cellMeasure(before[m], c), 1.0, 1e-12);
    }
  }
}

TEST_P(BisectionOf, EveryCellHasAsManyDescendantsAsWereAskedFor)
{
  Bisection bisection(start(), twins());
  for (unsigned round = 0; round < 3; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    const auto halvings = randomHalvings(before, 17 + round, 7);
    bisection.refine(halvings);
    for (std::size_t m = 0; m < before.size(); ++m) {
      const std::vector<int>& parents = bisection.parents()[m];
      EXPECT_TRUE(std::is_sorted(parents.begin(), parents.end()));
      for (int c = 0; c < before[m].numCells(); ++c)
        EXPECT_GE(std::count(parents.begin(), parents.end(), c), 1 << halvings[m][std::size_t(c)]);
    }
  }
}

TEST_P(BisectionOf, PointsKeepTheirNumbersAndBits)
{
  Bisection bisection(start(), twins());
  for (unsigned round = 0; round < 3; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    bisection.refine(randomHalvings(before, 100 + round));
    for (std::size_t m = 0; m < before.size(); ++m)
      EXPECT_TRUE(std::equal(before[m].points.begin(), before[m].points.end(), bisection.meshes()[m].points.begin()));
  }
}

TEST_P(BisectionOf, NothingAskedIsNothingChanged)
{
  Bisection bisection(start(), twins());
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
  int ends[2];
  facetVertices(mesh, facet, ends);
  for (std::size_t f = 0; f < parents.facets.size(); ++f) {
    const int* cell = before.cell(parents.facets[f].cell);
    const double* a = before.point(cell[(parents.facets[f].local + 1) % 3]);
    const double* b = before.point(cell[(parents.facets[f].local + 2) % 3]);
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const auto isIn = [&](int v) {
      const double* x = mesh.point(v);
      return std::hypot(x[0] - a[0], x[1] - a[1]) + std::hypot(b[0] - x[0], b[1] - x[1]) < (1.0 + 1e-12) * length;
    };
    if (std::all_of(ends, ends + 2, isIn))
      return int(f);
  }
  return -1;
}

TEST_P(BisectionOf, SidesConsistOfTheHalvesOfTheirFacetsInTheirOrder)
{
  Bisection bisection(start(), twins());
  for (unsigned round = 0; round < 3; ++round) {
    const std::vector<Mesh> before = bisection.meshes();
    bisection.refine(randomHalvings(before, 200 + round, 5));
    for (std::size_t m = 0; m < before.size(); ++m) {
      const Mesh& mesh = bisection.meshes()[m];
      ASSERT_EQ(mesh.sides.size(), before[m].sides.size());
      for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
        EXPECT_EQ(mesh.sides[s].name, before[m].sides[s].name);
        const double length = measure(before[m], before[m].sides[s]);
        EXPECT_NEAR(measure(mesh, mesh.sides[s]), length, 1e-12 * length);
        int last = 0, lastEnd = -1;
        for (const Facet facet : mesh.sides[s].facets) {
          const int now = parentFacet(before[m].sides[s], before[m], mesh, facet);
          EXPECT_GE(now, last);
          EXPECT_TRUE(now != last || lastEnd < 0 || lastEnd == mesh.cell(facet.cell)[(facet.local + 1) % 3]);
          lastEnd = mesh.cell(facet.cell)[(facet.local + 2) % 3];
          last = now;
        }
      }
    }
  }
}

TEST_P(BisectionOfSquares, ManyHalvingsAtOnceAreManyCallsOfOne)
{
  Bisection atOnce(start(), twins()), oneByOne(start(), twins());
  auto left = randomHalvings(start(), 5, 6);
  atOnce.refine(left);
  for (int call = 0; call < 5; ++call) {
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
    EXPECT_EQ(cornersOf(atOnce.meshes()[m]), cornersOf(oneByOne.meshes()[m]));
}

TEST_P(BisectionOf, DoesNotDependOnTheOrderOfTheBodies)
{
  const std::vector<Mesh> turned(start().rbegin(), start().rend());
  Bisection bisection(start(), twins()), reversed(turned, findTwins(turned));
  for (unsigned round = 0; round < 3; ++round) {
    auto halvings = randomHalvings(bisection.meshes(), 300 + round);
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

/// The same body with other numbers of the points, the cells in another order, each beginning with another vertex.
Mesh renumbered(const Mesh& mesh, const std::vector<int>& oldCells)
{
  const std::vector<int> newPoints = shuffled(mesh.numPoints());
  Mesh other{2, mesh.points, {}, {}, {}};
  for (int p = 0; p < mesh.numPoints(); ++p)
    std::copy_n(mesh.point(p), 2, other.points.begin() + 2 * newPoints[std::size_t(p)]);
  for (const int old : oldCells)
    for (int k = 0; k < 3; ++k)
      other.cells.push_back(newPoints[std::size_t(mesh.cell(old)[(k + old) % 3])]);
  return other;
}

TEST_P(BisectionOf, DoesNotDependOnTheNumbering)
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
  Bisection bisection(start(), twins()), other(others, findTwins(others));
  bisection.refine(halvings);
  other.refine(permuted);
  for (std::size_t m = 0; m < start().size(); ++m)
    EXPECT_EQ(cornersOf(other.meshes()[m]), cornersOf(bisection.meshes()[m]));
}

TEST(Bisection, LengthsThatDifferByRoundOffAreEqual)
{
  Mesh moved = equilateral(6);
  for (double& x : moved.points)
    x += 1000.0;
  Bisection here({equilateral(6)}, {}), there({moved}, {});
  const auto halvings = randomHalvings(here.meshes(), 8);
  here.refine(halvings);
  there.refine(halvings);
  EXPECT_EQ(there.meshes()[0].cells, here.meshes()[0].cells);
}

TEST(Bisection, RefusesTwinsThatDoNotFit)
{
  const Mesh one = equilateral(1);
  Mesh above = one;
  for (std::size_t i = 1; i < above.points.size(); i += 2)
    above.points[i] += std::sqrt(0.75);
  for (std::size_t i = 0; i < above.points.size(); i += 2)
    above.points[i] += 0.5;
  EXPECT_NO_THROW(Bisection({one, above}, {{0, {1, 0}, 1, {0, 2}}}));
  EXPECT_THROW(Bisection({one, one}, {{0, {1, 0}, 1, {1, 0}}}), InternalError);   // the same side of a line
  EXPECT_THROW(Bisection({one, above}, {{0, {0, 0}, 1, {0, 2}}}), InternalError); // inside a body
  EXPECT_THROW(Bisection({one}, {}).refine({{1}}), InternalError);                // one cell too few
}

} // namespace
