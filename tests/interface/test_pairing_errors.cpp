#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace
{

BodyModel upper(const std::string& lower = "0, 0", const std::string& cells = "4, 2")
{
  return boxBody("upper", box(lower, "2, 1", cells), 1);
}

BodyModel lower(const std::string& top = "2, 0", const std::string& cells = "4, 3")
{
  return boxBody("lower", box("0, -1", top, cells), 1);
}

std::string complaint(const InterfaceSettings& entry, const BodyModel& dirichlet, const BodyModel& neumann)
{
  try {
    pairSides(entry, dirichlet, neumann);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

} // namespace

TEST(PairingErrors, MissingSideListsTheSidesOfItsBody)
{
  EXPECT_THAT(complaint(interfaceEntry("botom", "top"), upper(), lower()),
              AllOf(HasSubstr("body \"upper\" has no side \"botom\""), HasSubstr("left, right, bottom, top"),
                    HasSubstr("test.xml:")));
  EXPECT_THAT(complaint(interfaceEntry("bottom", "tip"), upper(), lower()),
              HasSubstr("body \"lower\" has no side \"tip\""));
}

TEST(PairingErrors, FinerDirichletSideSaysHowManyNodesMissTheirPartner)
{
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top"), upper("0, 0", "8, 2"), lower()),
              AllOf(HasSubstr("the sides do not match (upper/bottom and lower/top)"),
                    HasSubstr("4 of 9 nodes have no partner"), HasSubstr("largest distance is 0.25 at (0.25, 0)")));
}

TEST(PairingErrors, LongerNeumannSideSaysHowManyNodesMissTheirPartner)
{
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top"), upper(), lower("3, 0", "6, 3")),
              AllOf(HasSubstr("2 of 7 nodes have no partner"), HasSubstr("largest distance is 1 at (3, 0)")));
}

TEST(PairingErrors, OverlapSaysByHowMuchAndWhere)
{
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top"), upper("0, -0.125"), lower()),
              AllOf(HasSubstr("the bodies overlap at the start: by 0.125 at (0, -0.125)"), HasSubstr("upper/bottom")));
}

TEST(PairingErrors, SidesThatAreApartLearnAboutTheGap)
{
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top"), upper("0, 0.125"), lower()),
              AllOf(HasSubstr("the sides are apart by 0.125 at (0, 0.125)"), HasSubstr("give the opening as Gap")));
}

TEST(PairingErrors, BodiesOnTheSameSideOverlap)
{
  const auto inside = boxBody("inside", box("0, 0", "2, 2", "4, 3"), 1);
  EXPECT_THAT(complaint(interfaceEntry("bottom", "bottom"), upper(), inside),
              AllOf(HasSubstr("overlap at the start"), HasSubstr("\"upper\" and \"inside\" lie on the same side"),
                    HasSubstr("at (0, 0)")));
}

TEST(PairingErrors, NegativeGapIsAnOverlap)
{
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top", "x - 1.5"), upper(), lower()),
              AllOf(HasSubstr("overlap at the start: the gap is -1.5 at (0, 0)"), HasSubstr("must not be negative")));
}

TEST(PairingErrors, GapThatIsNotFiniteIsRefusedWithItsPlace)
{
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top", "1/(x - 1)^2"), upper(), lower()),
              HasSubstr("\"1/(x - 1)^2\" is inf at (1, 0)"));
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top", "sqrt(x - 1)"), upper(), lower()), HasSubstr("nan at (0, 0)"));
}

TEST(PairingErrors, SharedNodesWithDifferentFacetsAreSaidToBeThat)
{
  const auto above = boxBody("above", box("0, 0, 0", "1, 1, 1", "3, 3, 1"), 1);
  const auto below = boxBody("below", box("0, 0, -1", "1, 1, 0", "3, 3, 1") + text("Pattern", "Alternating"), 1);
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top"), above, below), HasSubstr("cut into different facets"));
}

TEST(PairingErrors, DistancesBelowTheToleranceOfAMeshFileAreNotSeen)
{
  EXPECT_EQ(complaint(interfaceEntry("bottom", "top"), upper("0, 1e-7"), lower()), "no complaint");
  EXPECT_THAT(complaint(interfaceEntry("bottom", "top"), upper("0, 1e-4"), lower()), Not(HasSubstr("no complaint")));
}
