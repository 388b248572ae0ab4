#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"

namespace
{

using namespace ndframe::test;
using testing::AllOf;
using testing::HasSubstr;

std::string box(const std::string& lower, const std::string& upper, const std::string& cells,
                const std::string& more = {})
{
  return text("Type", "Box") + doubles("Lower", lower) + doubles("Upper", upper) + ints("Cells", cells) + more;
}

std::string unitBox(const std::string& more)
{
  return box("0, 0", "1, 1", "4, 4", more);
}

std::string split(const std::string& side, const std::string& at, const std::string& names,
                  const std::string& more = {})
{
  return list("Splits", list("cut", text("Side", side) + doubles("At", at) + strings("Names", names) + more));
}

TEST(BoxErrors, NameTheDeckAndTheList)
{
  EXPECT_THAT(messageOf(box("0, 0", "0, 1", "4, 4")), HasSubstr("test.xml:5: Mesh: Upper must be"));
}

TEST(BoxErrors, ExtentsMustGrow)
{
  EXPECT_THAT(messageOf(box("0, 0", "1, 0", "4, 4")),
              HasSubstr("Upper must be larger than Lower in direction Y, but 0 and 0 are given."));
  EXPECT_THAT(messageOf(box("2, 0", "1, 1", "4, 4")), HasSubstr("in direction X, but 2 and 1 are given."));
}

TEST(BoxErrors, LengthsMustAgree)
{
  EXPECT_THAT(messageOf(box("0", "1", "4")), HasSubstr("Lower has 1 coordinates; a box has 2 or 3."));
  EXPECT_THAT(messageOf(box("0, 0", "1, 1, 1", "4, 4")), HasSubstr("Upper has 3 entries but Lower has 2"));
  EXPECT_THAT(messageOf(box("0, 0", "1, 1", "4")), HasSubstr("Cells has 1 entries but Lower has 2"));
  EXPECT_THAT(messageOf(unitBox(doubles("Grading", "1"))), HasSubstr("Grading has 1 entries but Lower has 2"));
}

TEST(BoxErrors, AreCollected)
{
  EXPECT_THAT(messageOf(box("0, 0", "0, 1", "0, 4")),
              AllOf(HasSubstr("Upper must be larger"), HasSubstr("0 cells in a direction; at least 1 is needed.")));
}

TEST(BoxErrors, MeshMustFitInMemory)
{
  EXPECT_THAT(messageOf(box("0, 0", "1, 1", "100000, 100000")),
              HasSubstr("Cells make 2e+10 simplices, more than can be"));
  EXPECT_THAT(messageOf(box("0, 0, 0", "1, 1, 1", "2000000000, 2000000000, 2000000000")), HasSubstr("use fewer"));
}

TEST(BoxErrors, GradingMustBeModerate)
{
  EXPECT_THAT(messageOf(unitBox(doubles("Grading", "-1, 1"))), HasSubstr("Grading = -1 is outside [1e-6, 1e6]."));
}

TEST(BoxErrors, CrossedIsTwoDimensional)
{
  EXPECT_THAT(messageOf(box("0, 0, 0", "1, 1, 1", "2, 2, 2", text("Pattern", "Crossed"))),
              HasSubstr("Crossed is for boxes in two dimensions; use Right or Alternating."));
}

TEST(BoxErrors, PatternMustExist)
{
  EXPECT_THAT(messageOf(unitBox(text("Pattern", "Cross"))), HasSubstr("Crossed"));
}

TEST(BoxErrors, CellSizesMustBeAProfile)
{
  const auto sizes = [](const std::string& at, const std::string& size) {
    return unitBox(list("Cell Sizes X", doubles("At", at) + doubles("Size", size)));
  };
  EXPECT_THAT(messageOf(sizes("0, 1", "1")), HasSubstr("1 sizes for 2 points"));
  EXPECT_THAT(messageOf(sizes("1, 0", "1, 2")), HasSubstr("the points must increase."));
  EXPECT_THAT(messageOf(sizes("0, 1", "0, 1")), HasSubstr("the sizes must be positive and within a factor of 1e6."));
  EXPECT_THAT(messageOf(unitBox(list("Cell Sizes Z", doubles("At", "0") + doubles("Size", "1")))),
              HasSubstr("a box in two dimensions has no direction Z."));
  EXPECT_THAT(
      messageOf(unitBox(doubles("Grading", "2, 1") + list("Cell Sizes X", doubles("At", "0") + doubles("Size", "1")))),
      HasSubstr("direction X has both a Grading and a list Cell Sizes X"));
}

TEST(BoxErrors, SplitPointsMustLieInsideAndIncrease)
{
  EXPECT_THAT(messageOf(unitBox(split("top", "1", "a, b"))), HasSubstr("At = 1 is outside (0, 1)."));
  EXPECT_THAT(messageOf(unitBox(split("top", "0.7, 0.3", "a, b, c"))),
              HasSubstr("the points must increase, but 0.3 follows 0.7."));
}

TEST(BoxErrors, SplitNeedsOneNameMore)
{
  EXPECT_THAT(messageOf(unitBox(split("top", "0.5", "a"))),
              HasSubstr("1 points cut the side into 2 parts, but 1 names are given."));
}

TEST(BoxErrors, SplitNamesMustDiffer)
{
  EXPECT_THAT(messageOf(unitBox(split("top", "0.5", "left, b"))),
              HasSubstr("two sides are called \"left\"; names must differ."));
}

TEST(BoxErrors, SplitSideMustExist)
{
  EXPECT_THAT(messageOf(unitBox(split("front", "0.5", "a, b"))),
              HasSubstr("a box in two dimensions has no side \"front\""));
  EXPECT_THAT(messageOf(unitBox(split("tob", "0.5", "a, b"))), HasSubstr("top"));
}

TEST(BoxErrors, SplitDirectionMustLieInTheSide)
{
  EXPECT_THAT(messageOf(unitBox(split("top", "0.5", "a, b", text("Direction", "Y")))),
              HasSubstr("the side top does not extend in direction Y."));
}

TEST(BoxErrors, SplitsNeedEnoughCells)
{
  EXPECT_THAT(messageOf(box("0, 0", "1, 1", "2, 2", split("top", "0.2, 0.6", "a, b, c"))),
              HasSubstr("2 cells in direction X are too few for the splits, which need 3."));
}

TEST(BoxErrors, BoxMustNotBeTooThinForDoublePrecision)
{
  EXPECT_THAT(messageOf(box("1, 0", "1.000000000000001, 1", "40, 1")),
              HasSubstr("the box is too thin for double precision"));
}

} // namespace
