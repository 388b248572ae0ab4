#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "ndframe/interface/insertion.hpp"

using namespace ndframe;

namespace
{

using Curve = std::function<double(double)>;

/// A strip of triangles between a curve, its side "contact", and a straight line at height y.
Mesh strip(const std::vector<double>& x, const Curve& curve, double y)
{
  Mesh mesh;
  mesh.dim = 2;
  const int n = int(x.size());
  for (const double at : x)
    mesh.points.insert(mesh.points.end(), {at, curve(at)});
  for (const double at : x)
    mesh.points.insert(mesh.points.end(), {at, y});
  Side contact{"contact", {}};
  for (int i = 0; i + 1 < n; ++i) {
    const int a = i, b = i + 1, c = n + i, d = n + i + 1;
    const bool below = y < curve(x[std::size_t(i)]);
    contact.facets.push_back({mesh.numCells(), below ? 0 : 2});
    if (below) // the curve is the upper side
      mesh.cells.insert(mesh.cells.end(), {c, b, a, c, d, b});
    else
      mesh.cells.insert(mesh.cells.end(), {a, b, c, b, d, c});
  }
  mesh.sides.push_back(contact);
  return mesh;
}

std::vector<double> spread(std::mt19937& random, int n, double from, double to)
{
  std::uniform_real_distribution<double> width(0.1, 1.0);
  std::vector<double> x{0.0};
  for (int i = 0; i < n; ++i)
    x.push_back(x.back() + width(random));
  const double whole = x.back();
  for (double& at : x)
    at = from + (to - from) * at / whole;
  return x;
}

SideMap mapOf(const Mesh& upper, const Mesh& lower)
{
  return {SidePolygon(upper, upper.sides[0].facets, 35.0), SidePolygon(lower, lower.sides[0].facets, 35.0)};
}

double lengthOf(const SideMap& map)
{
  double sum = 0.0;
  for (const SideSegment& segment : map.segments())
    sum += std::abs(segment.first[1] - segment.first[0]) * map.first().edges()[std::size_t(segment.firstEdge)].length();
  return sum;
}

/// Meshes that were cut match: every piece is a whole facet on both sides.
void expectWholeFacets(const std::vector<Mesh>& meshes, const std::shared_ptr<const SideMap>& map, double length)
{
  const auto cut = insertion(meshes, {{0, 1, "contact", "contact", map}});
  const Mesh &upper = cut[0].mesh, &lower = cut[1].mesh;
  for (const Mesh* mesh : {&upper, &lower})
    EXPECT_TRUE(checkMesh(*mesh).empty()) << checkMesh(*mesh).front();
  const auto pieces = facingPieces(*map, upper, upper.sides[0].facets, lower, lower.sides[0].facets);
  double sum = 0.0, normal[2];
  for (const FacingPiece& piece : pieces) {
    for (const auto& places : {piece.onFirst, piece.onSecond})
      EXPECT_NEAR(std::abs(places[1] - places[0]), 1.0, 1e-7);
    const double one = facetNormal(upper, piece.first, normal), other = facetNormal(lower, piece.second, normal);
    EXPECT_LT(std::max(one, other) / std::min(one, other), 2.2);
    sum += one;
  }
  EXPECT_NEAR(sum, length, 1e-9);
}

} // namespace

TEST(SideMap, OfStraightSidesIsTheIdentity)
{
  std::mt19937 random(2);
  const Curve flat = [](double) { return 0.0; };
  for (int trial = 0; trial < 20; ++trial) {
    const Mesh upper = strip(spread(random, 1 + trial % 7, 0.0, 1.0), flat, 1.0);
    const Mesh lower = strip(spread(random, 1 + trial % 5, 0.0, 1.0), flat, -1.0);
    const auto map = std::make_shared<const SideMap>(mapOf(upper, lower));
    ASSERT_EQ(map->segments().size(), 1u);
    EXPECT_TRUE(map->isSameLine(map->segments()[0]));
    EXPECT_TRUE(map->touches());
    EXPECT_EQ(map->largestOpening(), 0.0);
    expectWholeFacets({upper, lower}, map, 1.0);
  }
}

TEST(SideMap, CoversWhatBothSidesHave)
{
  std::mt19937 random(3);
  const Curve flat = [](double) { return 0.0; };
  const Mesh upper = strip(spread(random, 5, 0.3, 1.4), flat, 1.0),
             lower = strip(spread(random, 7, 0.0, 1.0), flat, -1.0);
  const auto map = std::make_shared<const SideMap>(mapOf(upper, lower));
  EXPECT_NEAR(lengthOf(*map), 0.7, 1e-14);
  expectWholeFacets({upper, lower}, map, 0.7);
}

TEST(SideMap, TellsSidesOfOneCurveFromSidesThatAreApart)
{
  std::mt19937 random(4);
  const Curve curve = [](double x) { return 0.1 * std::cos(3.0 * x); };
  for (const double gap : {0.0, 1e-3, 0.05}) {
    const auto map = std::make_shared<const SideMap>(
        mapOf(strip(
                  spread(random, 12, 0.0, 1.0), [&](double x) { return curve(x) + gap; }, 1.0),
              strip(spread(random, 17, 0.0, 1.0), curve, -1.0)));
    EXPECT_EQ(map->touches(), gap == 0.0);
    EXPECT_EQ(map->deepestOverlap(map->outlines()).first < 0.0, gap == 0.0);
    for (const SideSegment& segment : map->segments())
      if (gap > 0.0) {
        EXPECT_NEAR(map->opening(segment, 0.5, SideMap::Shape::Curves), gap, 0.05 * gap + 1e-4);
      }
  }
}

TEST(SideMap, FindsTheGapOfARoundBodyAboveAFlatOne)
{
  const Curve arc = [](double x) { return 1.0 - std::sqrt(1.0 - x * x); };
  double before = HUGE_VAL;
  for (const int n : {5, 10, 20}) {
    std::vector<double> x;
    for (int i = 0; i <= n; ++i)
      x.push_back(0.4 * i / n);
    const auto map = mapOf(strip(x, arc, 1.0), strip(
                                                   {0.0, 0.07, 0.2, 0.5}, [](double) { return 0.0; }, -1.0));
    double worst = 0.0;
    for (const SideSegment& segment : map.segments()) {
      const double y = map.pointOnSecond(segment, 0.5)[0]; // the ray runs through the centre of the arc
      const double exact = std::hypot(1.0, y) - 1.0;
      worst = std::max(worst, std::abs(map.opening(segment, 0.5, SideMap::Shape::Curves) - exact));
    }
    EXPECT_LT(worst, 0.3 * before);
    before = worst;
  }
  EXPECT_LT(before, 2e-5);
}

/// Where a side is kinked, rays from both edges cross behind it, and what both claim is divided: nothing that is left
/// over is a part, for such parts would cut meshes one after the other (1e-8 of an edge once did).
TEST(SideMap, HasNoPartsOfRoundOffLength)
{
  std::mt19937 random(8007);
  for (int trial = 0; trial < 400; ++trial) {
    std::uniform_real_distribution<double> draw(0.0, 1.0);
    const double gap = 0.02 * draw(random), slope = 0.05 * draw(random), bow = 0.1 * draw(random);
    const auto above = [&](double x) { return gap + slope * x + bow * x * x; };
    const auto below = [&](double x) { return -0.5 * bow * x * x; };
    const SideMap map = mapOf(strip(spread(random, 1 + trial % 7, 0.0, 1.0), above, 1.0),
                              strip(spread(random, 1 + trial % 5, 0.0, 1.0), below, -1.0));
    for (const SideSegment& segment : map.segments()) {
      EXPECT_GT(std::abs(segment.first[1] - segment.first[0]), 1e-7);
      EXPECT_GT(std::abs(segment.second[1] - segment.second[0]), 1e-7);
    }
  }
}

TEST(SideMap, HasNoPartWhereSidesLookAway)
{
  const Curve flat = [](double) { return 0.0; };
  EXPECT_TRUE(mapOf(strip({0.0, 1.0}, flat, -1.0), strip({0.0, 0.5, 1.0}, flat, -1.0)).segments().empty());
}

TEST(Insertion, ComesToNothingOnMeshesThatMatch)
{
  const Curve flat = [](double) { return 0.0; };
  const Mesh upper = strip({0.0, 0.3, 1.0}, flat, 1.0), lower = strip({0.0, 0.3, 1.0}, flat, -1.0);
  for (const auto& mesh :
       insertion({upper, lower}, {{0, 1, "contact", "contact", std::make_shared<const SideMap>(mapOf(upper, lower))}}))
    EXPECT_TRUE(mesh.parents.empty());
}

TEST(Insertion, MovesVerticesThatAlmostMeet)
{
  const Curve flat = [](double) { return 0.0; };
  const Mesh upper = strip({0.0, 0.5, 1.0}, flat, 1.0), lower = strip({0.0, 0.51, 1.0}, flat, -1.0);
  const auto cut =
      insertion({upper, lower}, {{0, 1, "contact", "contact", std::make_shared<const SideMap>(mapOf(upper, lower))}});
  EXPECT_EQ(cut[0].mesh.numCells(), upper.numCells());
  EXPECT_EQ(cut[1].mesh.numCells(), lower.numCells());
  EXPECT_EQ(cut[1].mesh.point(1)[0], 0.5);
}
