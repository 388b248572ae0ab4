// Which sides face each other, on random blocks where a count by intervals knows it.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "ndframe/interface/facing_search.hpp"

using namespace ndframe;

namespace
{

struct Rectangle
{
  std::array<double, 2> low, high;
};

using Place = std::function<std::array<double, 2>(double, double)>;

std::array<double, 2> asIs(double x, double y)
{
  return {x, y};
}

/// A grid of triangles on a rectangle with the sides bottom, right, top, left.
Mesh meshOf(const Rectangle& r, int n, int m, const Place& place = asIs)
{
  Mesh mesh;
  mesh.dim = 2;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const auto at = place(r.low[0] + (r.high[0] - r.low[0]) * i / n, r.low[1] + (r.high[1] - r.low[1]) * j / m);
      mesh.points.insert(mesh.points.end(), at.begin(), at.end());
    }
  mesh.sides = {{"bottom", {}}, {"right", {}}, {"top", {}}, {"left", {}}};
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1, cell = mesh.numCells();
      mesh.cells.insert(mesh.cells.end(), {a, b, c, a, c, d});
      const std::array<bool, 4> isAtEnd{j == 0, i == n - 1, j == m - 1, i == 0};
      const std::array<Facet, 4> facets{{{cell, 2}, {cell, 0}, {cell + 1, 0}, {cell + 1, 1}}};
      for (std::size_t k = 0; k < 4; ++k)
        if (isAtEnd[k])
          mesh.sides[k].facets.push_back(facets[k]);
    }
  return mesh;
}

std::vector<SearchedBody> bodiesOf(const std::vector<Mesh>& meshes)
{
  std::vector<SearchedBody> bodies;
  for (const Mesh& mesh : meshes)
    bodies.push_back({&mesh, {}, {}});
  return bodies;
}

FacingSearch search(const std::vector<Mesh>& meshes, double distance)
{
  return searchFacing(bodiesOf(meshes), distance, 35.0);
}

/// "0 top - 1 bottom".
std::string nameOf(const FacingPair& pair)
{
  return std::to_string(pair.firstBody) + " " + pair.firstSide + " - " + std::to_string(pair.secondBody) + " " +
         pair.secondSide;
}

std::set<std::string> namesOf(const FacingSearch& found)
{
  std::set<std::string> names;
  for (const FacingPair& pair : found.pairs)
    names.insert(nameOf(pair));
  return names;
}

struct Truth
{
  double length = 0.0, smallest = HUGE_VAL, largest = 0.0;
};

/// What the sides of upright rectangles face, counted on the intervals between all their ends.
std::map<std::string, Truth> truthOf(const std::vector<Rectangle>& blocks, double distance)
{
  std::map<std::string, Truth> truth;
  const char* const names[4] = {"bottom", "right", "top", "left"};
  for (std::size_t a = 0; a < blocks.size(); ++a)
    for (std::size_t side = 0; side < 4; ++side) {
      const std::size_t across = side % 2 == 0 ? 1 : 0, along = 1 - across;
      const bool isUpper = side == 1 || side == 2;
      const double at = isUpper ? blocks[a].high[across] : blocks[a].low[across];
      std::set<double> ends;
      for (const Rectangle& block : blocks)
        for (const double end : {block.low[along], block.high[along]})
          ends.insert(std::clamp(end, blocks[a].low[along], blocks[a].high[along]));
      for (auto from = ends.begin(), to = std::next(from); to != ends.end(); ++from, ++to) {
        const double middle = 0.5 * (*from + *to);
        std::size_t nearest = blocks.size();
        double opening = HUGE_VAL;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
          const double apart = isUpper ? blocks[b].low[across] - at : at - blocks[b].high[across];
          if (b != a && blocks[b].low[along] < middle && middle < blocks[b].high[along] && apart > -1e-12 &&
              apart < opening) {
            nearest = b;
            opening = apart;
          }
        }
        if (nearest == blocks.size() || nearest < a || opening > distance)
          continue;
        Truth& one = truth[std::to_string(a) + " " + names[side] + " - " + std::to_string(nearest) + " " +
                           names[(side + 2) % 4]];
        one.length += *to - *from;
        one.smallest = std::min(one.smallest, opening);
        one.largest = std::max(one.largest, opening);
      }
    }
  return truth;
}

/// Cuts a rectangle at random, leaving gaps of all sizes, thin blocks among them.
void cutUp(std::mt19937& random, const Rectangle& whole, int depth, double distance, std::vector<Rectangle>& blocks)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  if (depth == 0 || unit(random) < 0.1) {
    blocks.push_back(whole);
    return;
  }
  const std::size_t across = unit(random) < 0.5 ? 0 : 1;
  const double gaps[] = {0.0, 0.0, 0.4 * distance, 0.95 * distance, 1.5 * distance};
  const double size = whole.high[across] - whole.low[across], gap = std::min(gaps[random() % 5], 0.1 * size);
  const double share = unit(random) < 0.2 ? 0.02 : 0.2 + 0.6 * unit(random);
  Rectangle lower = whole, upper = whole;
  lower.high[across] = whole.low[across] + share * (size - gap);
  upper.low[across] = lower.high[across] + gap;
  cutUp(random, lower, depth - 1, distance, blocks);
  cutUp(random, upper, depth - 1, distance, blocks);
}

void expectTruth(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double distance = unit(random) < 0.3 ? 0.0 : 0.1 * unit(random),
               turn = unit(random) < 0.3 ? 0.0 : 6.3 * unit(random);
  std::vector<Rectangle> blocks;
  cutUp(random, {{0.0, 0.0}, {1.0, 1.5}}, 2 + int(random() % 4), distance, blocks);
  std::shuffle(blocks.begin(), blocks.end(), random);
  const Place turned = [&](double x, double y) -> std::array<double, 2> {
    return {std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y};
  };
  std::vector<Mesh> meshes;
  for (const Rectangle& block : blocks)
    meshes.push_back(meshOf(block, 1 + int(random() % 3), 1 + int(random() % 3), turned));
  const FacingSearch found = search(meshes, distance);
  const auto truth = truthOf(blocks, distance);
  const auto lengths = [](const std::map<std::string, Truth>& sides) {
    double sum = 0.0;
    for (const auto& [name, one] : sides)
      sum += one.length;
    return sum;
  };
  if (lengths(truthOf(blocks, distance + 4e-6)) > lengths(truth)) // openings at the limit are in or out by round-off
    return;
  const std::set<std::string> names = namesOf(found);
  for (const auto& [name, one] : truth)
    ASSERT_TRUE(names.count(name)) << name << " is not found, over " << one.length << ", within " << one.largest;
  for (const FacingPair& pair : found.pairs)
    ASSERT_TRUE(truth.count(nameOf(pair)))
        << nameOf(pair) << " is none, over " << pair.length << ", from " << pair.smallest << ", within " << distance;
  EXPECT_TRUE(found.unnamed.empty());
  for (const FacingPair& pair : found.pairs) {
    const Truth& one = truth.at(nameOf(pair));
    EXPECT_NEAR(pair.length, one.length, 1e-9) << nameOf(pair);
    EXPECT_NEAR(pair.smallest, one.smallest, 1e-9) << nameOf(pair);
    EXPECT_NEAR(pair.largest, one.largest, 1e-9) << nameOf(pair);
  }
}

} // namespace

/// In full: NDFRAME_SCENES=100000 test_interface --gtest_filter=FacingSearch.FindsWhatRandomBlocksFace
TEST(FacingSearch, FindsWhatRandomBlocksFace)
{
  const char* const wanted = std::getenv("NDFRAME_SCENES");
  const int scenes = wanted == nullptr ? 400 : std::atoi(wanted);
  for (int scene = 0; scene < scenes; ++scene) {
    SCOPED_TRACE("scene " + std::to_string(scene));
    std::mt19937 random{unsigned(scene)};
    expectTruth(random);
    if (HasFatalFailure())
      return;
  }
}

TEST(FacingSearch, CornersThatMeetFaceNothing)
{
  const FacingSearch found =
      search({meshOf({{0, 0}, {1, 1}}, 2, 2), meshOf({{1, 1}, {2, 2}}, 3, 3), meshOf({{1, 0}, {2, 1}}, 2, 2)}, 0.1);
  EXPECT_EQ(namesOf(found), (std::set<std::string>{"0 right - 2 left", "1 bottom - 2 top"}));
}

TEST(FacingSearch, WhatLiesBehindAThinSheetIsNotSeen)
{
  const FacingSearch found = search(
      {meshOf({{0, 0}, {1, 1}}, 2, 2), meshOf({{0, 1}, {1, 1.01}}, 4, 1), meshOf({{0, 1.01}, {1, 2}}, 2, 2)}, 0.5);
  EXPECT_EQ(namesOf(found), (std::set<std::string>{"0 top - 1 bottom", "1 top - 2 bottom"}));
}

TEST(FacingSearch, ABodyFacesItselfWithTwoSidesNotWithOne)
{
  Mesh clamp = meshOf({{0, 0}, {1, 1}}, 2, 2);
  const Mesh other = meshOf({{0, 1.01}, {1, 2}}, 2, 2);
  const int shift = clamp.numPoints();
  const int cells = clamp.numCells();
  clamp.points.insert(clamp.points.end(), other.points.begin(), other.points.end());
  for (const int v : other.cells)
    clamp.cells.push_back(v + shift);
  for (std::size_t s = 0; s < 4; ++s)
    for (const Facet facet : other.sides[s].facets)
      clamp.sides[s].facets.push_back({facet.cell + cells, facet.local});
  const Mesh apart = meshOf({{3, 0}, {4, 1}}, 1, 1);
  EXPECT_EQ(namesOf(search({clamp, apart}, 0.1)), (std::set<std::string>{"0 bottom - 0 top"}));
  for (Side& side : clamp.sides)
    side.name = "skin";
  Side skin{"skin", {}};
  for (const Side& side : clamp.sides)
    skin.facets.insert(skin.facets.end(), side.facets.begin(), side.facets.end());
  clamp.sides = {skin};
  EXPECT_TRUE(search({clamp, apart}, 0.1).pairs.empty());
}

TEST(FacingSearch, SteepSidesFaceNothing)
{
  const auto wedge = [](double degrees) {
    const double slope = std::tan(degrees * std::acos(-1.0) / 180.0);
    const Place rising = [slope](double x, double y) -> std::array<double, 2> { return {x, y + slope * x}; };
    return search({meshOf({{0, -1}, {1, 0}}, 2, 2), meshOf({{0, 0}, {1, 1}}, 2, 2, rising)}, 0.1);
  };
  EXPECT_EQ(namesOf(wedge(20)), (std::set<std::string>{"0 top - 1 bottom"}));
  EXPECT_NEAR(wedge(20).pairs[0].length, 0.1 / std::tan(20 * std::acos(-1.0) / 180.0), 1e-5);
  EXPECT_NEAR(wedge(20).pairs[0].largest, 0.1, 1e-5);
  EXPECT_TRUE(wedge(30).pairs.empty());
}

TEST(FacingSearch, PolygonsOfOneArcTouchWithoutADistance)
{
  const auto ring = [](double inner, double outer, int n) {
    const Place polar = [](double angle, double r) -> std::array<double, 2> {
      return {-r * std::cos(angle), r * std::sin(angle)};
    };
    return meshOf({{0, inner}, {1.5, outer}}, n, 2, polar);
  };
  const FacingSearch found = search({ring(1, 2, 7), ring(2, 3, 12)}, 0.0);
  ASSERT_EQ(namesOf(found), (std::set<std::string>{"0 top - 1 bottom"}));
  EXPECT_NEAR(found.pairs[0].length, 3.0, 0.02);
}

TEST(FacingSearch, OfSidesThatShareFacetsTheLongerCounts)
{
  Mesh lower = meshOf({{0, -1}, {2, 0}}, 4, 1);
  lower.sides.push_back({"part", {lower.sides[2].facets[0], lower.sides[2].facets[1]}});
  std::vector<Mesh> meshes{lower, meshOf({{0, 0}, {2, 1}}, 2, 1)};
  EXPECT_EQ(namesOf(search(meshes, 0.1)), (std::set<std::string>{"0 top - 1 bottom"}));
  std::vector<SearchedBody> bodies = bodiesOf(meshes);
  bodies[0].preferred = {"part"};
  const FacingSearch preferring = searchFacing(bodies, 0.1, 35.0);
  EXPECT_EQ(namesOf(preferring), (std::set<std::string>{"0 part - 1 bottom"}));
  ASSERT_EQ(preferring.unnamed.size(), 1u); // what "top" has besides
  EXPECT_EQ(preferring.unnamed[0].body, 0);
  EXPECT_NEAR(preferring.unnamed[0].place[0], 1.5, 1e-9);
}

TEST(FacingSearch, PartsThatMakeAWholeSideCountForIt)
{
  Mesh lower = meshOf({{0, -1}, {2, 0}}, 4, 1);
  const auto top = lower.sides[2].facets;
  const Side first{"first", {top[0], top[1]}}, second{"second", {top[2], top[3]}};
  lower.sides.push_back(first);
  lower.sides.push_back(second);
  lower.sides.push_back({"half of the first", {top[0]}});
  const FacingSearch found = search({lower, meshOf({{0, 0}, {2, 1}}, 2, 1)}, 0.1);
  EXPECT_EQ(namesOf(found), (std::set<std::string>{"0 first - 1 bottom", "0 second - 1 bottom"}));
  EXPECT_TRUE(found.unnamed.empty());
}

TEST(FacingSearch, FacetsWithoutANameAreToldWhereTheyFaceSomething)
{
  Mesh lower = meshOf({{0, -1}, {2, 0}}, 4, 1);
  lower.sides.erase(lower.sides.begin() + 2);
  const std::vector<Mesh> meshes{meshOf({{1, 0.05}, {2, 1}}, 1, 1), lower};
  const FacingSearch found = search(meshes, 0.1);
  EXPECT_TRUE(found.pairs.empty());
  ASSERT_EQ(found.unnamed.size(), 1u);
  EXPECT_EQ(found.unnamed[0].body, 1);
  EXPECT_EQ(found.unnamed[0].other, 0);
  EXPECT_NEAR(found.unnamed[0].length, 1.0, 1e-9);
  EXPECT_TRUE(search(meshes, 0.01).unnamed.empty());
}

TEST(FacingSearch, SidesThatAreLeftOutHideWhatIsBehind)
{
  const std::vector<Mesh> meshes{meshOf({{0, 0}, {1, 1}}, 1, 1), meshOf({{0, 1}, {1, 1.01}}, 1, 1),
                                 meshOf({{0, 1.01}, {1, 2}}, 1, 1)};
  std::vector<SearchedBody> bodies = bodiesOf(meshes);
  bodies[1].leftOut = {"bottom"};
  const FacingSearch found = searchFacing(bodies, 0.1, 35.0);
  EXPECT_EQ(namesOf(found), (std::set<std::string>{"1 top - 2 bottom"}));
  EXPECT_TRUE(found.unnamed.empty());
}

TEST(FacingSearch, NearestSidesAreKnownWhereNothingFaces)
{
  const std::vector<Mesh> meshes{meshOf({{0, 0}, {1, 1}}, 2, 2), meshOf({{0.2, 1.3}, {0.7, 2}}, 2, 2),
                                 meshOf({{5, 5}, {6, 6}}, 2, 2)};
  EXPECT_TRUE(search(meshes, 0.2).pairs.empty());
  const auto nearest = nearestSides(bodiesOf(meshes));
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->firstSide, "top");
  EXPECT_EQ(nearest->secondSide, "bottom");
  EXPECT_NEAR(nearest->distance, 0.3, 1e-12);
  EXPECT_FALSE(nearestSides(bodiesOf({meshes[0]})));
}
