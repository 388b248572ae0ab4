#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

struct Pair
{
  const char* name;
  std::string upperMesh, lowerMesh;
  const char *upperSide, *lowerSide;
  Direction normal; ///< outward of the upper body
  double measure;
};

std::string turned(const std::string& entries)
{
  return entries + "<Parameter name=\"Rotation\" type=\"double\" value=\"30\"/>\n";
}

Pair plane()
{
  return {"Plane",
          box("0, 0", "2, 1", "6, 3") + doubles("Grading", "8, 1"),
          box("0, -1", "2, 0", "6, 4") + doubles("Grading", "8, 2") + text("Pattern", "Crossed"),
          "bottom",
          "top",
          {0.0, -1.0, 0.0},
          2.0};
}

Pair turnedPlane()
{
  Pair pair = plane();
  pair.name = "TurnedPlane";
  pair.upperMesh = turned(pair.upperMesh);
  pair.lowerMesh = turned(pair.lowerMesh);
  pair.normal = {0.5, -std::sqrt(0.75), 0.0};
  return pair;
}

Pair space()
{
  return {"Space",
          box("0, 0, 0", "2, 1, 1", "3, 2, 2"),
          box("0, 0, -1", "2, 1, 0", "3, 2, 1"),
          "bottom",
          "top",
          {0.0, 0.0, -1.0},
          2.0};
}

std::string variantName(const testing::TestParamInfo<std::tuple<Pair, int, bool>>& variant)
{
  const auto& [pair, order, renumber] = variant.param;
  return pair.name + ("Order" + std::to_string(order)) + (renumber ? "Renumbered" : "");
}

class Pairing : public testing::TestWithParam<std::tuple<Pair, int, bool>>
{
protected:
  Pairing()
  {
    const auto& [pair, order, renumber] = GetParam();
    upper = boxBody("upper", pair.upperMesh, order);
    lower = boxBody("lower", pair.lowerMesh, order);
    if (renumber)
      lower = renumbered(lower);
    interface = pairSides(interfaceEntry(pair.upperSide, pair.lowerSide), upper, lower);
  }

  BodyModel upper, lower;
  InterfaceMesh interface;
};

} // namespace

TEST_P(Pairing, PairedNodesAreOnePoint)
{
  ASSERT_EQ(interface.neumann().nodes.size(), interface.dirichlet().nodes.size());
  for (int i = 0; i < interface.numNodes(); ++i)
    for (int k = 0; k < interface.dim; ++k) {
      const double x = interface.point(i)[k];
      EXPECT_EQ(upper.nodes.point(interface.dirichlet().nodes[std::size_t(i)])[k], x);
      EXPECT_NEAR(lower.nodes.point(interface.neumann().nodes[std::size_t(i)])[k], x, 1e-14);
    }
}

TEST_P(Pairing, EveryNodeOfBothSidesIsPairedOnce)
{
  const auto& pair = std::get<0>(GetParam());
  auto mine = interface.dirichlet().nodes, theirs = interface.neumann().nodes;
  std::sort(mine.begin(), mine.end());
  std::sort(theirs.begin(), theirs.end());
  EXPECT_EQ(mine, sideNodes(upper.nodes, *upper.side(pair.upperSide)));
  EXPECT_EQ(theirs, sideNodes(lower.nodes, *lower.side(pair.lowerSide)));
}

/// In space no numbering of the meshes counts; in the plane nodes ascend.
TEST_P(Pairing, NodesOfSolidsComeInTheOrderOfTheirPlaces)
{
  if (interface.dim < 3) {
    const std::vector<int>& nodes = interface.dirichlet().nodes;
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
    return;
  }
  const auto& pair = std::get<0>(GetParam());
  for (int i = 1; i < interface.numNodes(); ++i)
    EXPECT_TRUE(std::lexicographical_compare(interface.point(i - 1), interface.point(i - 1) + 3, interface.point(i),
                                             interface.point(i) + 3));
  const InterfaceMesh other = pairSides(interfaceEntry(pair.upperSide, pair.lowerSide), renumbered(upper), lower);
  EXPECT_EQ(other.points, interface.points);
}

TEST_P(Pairing, FacetsAreTheSameOnBothSides)
{
  const auto size = std::size_t(interface.nodesPerFacet());
  ASSERT_EQ(interface.neumann().facets.size(), interface.dirichlet().facets.size());
  for (std::size_t f = 0; f < interface.dirichlet().facets.size(); ++f) {
    std::vector<int> mine(size), theirs(size), expectedMine, expectedTheirs;
    facetNodes(upper.nodes, interface.dirichlet().facets[f], mine.data());
    facetNodes(lower.nodes, interface.neumann().facets[f], theirs.data());
    for (std::size_t a = 0; a < size; ++a) {
      const auto node = std::size_t(interface.facets[f * size + a]);
      expectedMine.push_back(interface.dirichlet().nodes[node]);
      expectedTheirs.push_back(interface.neumann().nodes[node]);
    }
    EXPECT_EQ(mine, expectedMine);
    std::sort(theirs.begin(), theirs.end());
    std::sort(expectedTheirs.begin(), expectedTheirs.end());
    EXPECT_EQ(theirs, expectedTheirs);
  }
}

TEST_P(Pairing, NormalsPointOutOfTheDirichletBody)
{
  for (const auto& normal : interface.normals)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(normal[k], std::get<0>(GetParam()).normal[k], 1e-14);
}

TEST_P(Pairing, MeasuresAddUpToTheSide)
{
  double sum = 0.0;
  for (const double measure : interface.measures)
    sum += measure;
  EXPECT_NEAR(sum, std::get<0>(GetParam()).measure, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(All, Pairing,
                         testing::Combine(testing::Values(plane(), turnedPlane(), space()), testing::Values(1, 2),
                                          testing::Bool()),
                         variantName);

TEST(PairingGap, IsTheExpressionAtTheNodes)
{
  const auto upper = boxBody("upper", plane().upperMesh, 2), lower = boxBody("lower", plane().lowerMesh, 2);
  const auto interface = pairSides(interfaceEntry("bottom", "top", "0.5*x^2 + y^2"), upper, lower);
  ASSERT_EQ(int(interface.gap.size()), interface.numNodes());
  for (int i = 0; i < interface.numNodes(); ++i)
    EXPECT_NEAR(interface.gap[std::size_t(i)], 0.5 * interface.point(i)[0] * interface.point(i)[0], 1e-15);
}

TEST(PairingGap, SeesTheThirdCoordinate)
{
  const auto front = boxBody("a", box("0, 0, 0", "1, 1, 1", "2, 2, 2"), 1);
  const auto behind = boxBody("b", box("0, 1, 0", "1, 2, 1", "2, 2, 2"), 1);
  const auto interface = pairSides(interfaceEntry("back", "front", "z"), front, behind);
  for (int i = 0; i < interface.numNodes(); ++i)
    EXPECT_EQ(interface.gap[std::size_t(i)], interface.point(i)[2]);
}

TEST(PairingUnits, TinyAndHugeBodiesPairAlike)
{
  for (const char* unit : {"1e-7", "1e7"}) {
    const std::string u = unit;
    const auto upper = boxBody("upper", box("0, 0", u + ", " + u, "5, 2"), 2);
    const auto lower = boxBody("lower", box("0, -" + u, u + ", 0", "5, 3"), 2);
    EXPECT_EQ(pairSides(interfaceEntry("bottom", "top"), upper, lower).numNodes(), 11);
  }
}

TEST(PairingPart, ANamedPartOfALongerSideIsEnough)
{
  const auto upper = boxBody("upper", box("0, 0", "1, 1", "4, 2"), 2);
  const auto lower = boxBody(
      "lower",
      box("0, -1", "2, 0", "8, 2") +
          list("Splits", list("top", text("Side", "top") + doubles("At", "1") +
                                         "<Parameter name=\"Names\" type=\"Array(string)\" value=\"{below, free}\"/>")),
      2);
  EXPECT_EQ(pairSides(interfaceEntry("bottom", "below"), upper, lower).numNodes(), 9);
}
