#include <cmath>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"

namespace ndframe
{

namespace
{

using test::Condition;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string refusal(const Mesh& mesh, const test::Conditions& conditions)
{
  return test::complaint([&] { test::makeBody(mesh, 1, conditions); });
}

Condition with(Condition condition, const std::string& key, const std::string& value)
{
  condition.entries.emplace_back(key, value);
  return condition;
}

Mesh square(double rotation = 0.0)
{
  return test::box({4, 4}, "Right", rotation);
}

/// The square with a side "arc" bent by `degrees` in its middle: the parts of the top to the left and right of x = 0.5.
Mesh withBentTop(double degrees)
{
  const double slope = std::tan(degrees * M_PI / 180.0);
  return test::moved(square(), [slope](double* x) { x[1] *= 1.0 + slope * std::max(0.0, x[0] - 0.5); });
}

} // namespace

TEST(Conditions, ASideThatDoesNotExistIsAnsweredWithTheSidesThatDo)
{
  const auto sides =
      AllOf(HasSubstr("no side \"botom\""), HasSubstr("the sides of this body are: left, right, bottom, top"));
  for (const char* type : {"Clamp", "Roller"})
    EXPECT_THAT(refusal(square(), {{test::onSide(type, "botom")}, {}}),
                AllOf(sides, HasSubstr("body.xml:"), HasSubstr("Supports/0")));
  EXPECT_THAT(refusal(square(), {{with(test::onSide("Displacement", "botom"), "X", "0")}, {}}), sides);
  EXPECT_THAT(refusal(square(), {{}, {with(test::onSide("Pressure", "botom"), "Value", "1")}}),
              AllOf(sides, HasSubstr("Loads/0")));
  EXPECT_THAT(refusal(square(), {{}, {test::onSide("Traction", "botom")}}), sides);
}

TEST(Conditions, AMeshWithoutSidesSaysSo)
{
  Mesh mesh = square();
  mesh.sides.clear();
  EXPECT_THAT(refusal(mesh, {{test::onSide("Clamp", "left")}, {}}), HasSubstr("this mesh has no named sides"));
}

TEST(Conditions, AllMistakesAreReportedAtOnce)
{
  EXPECT_THAT(refusal(square(), {{test::onSide("Clamp", "a"), test::onSide("Roller", "b")},
                                 {with(test::onSide("Pressure", "c"), "Value", "1")}}),
              AllOf(HasSubstr("\"a\""), HasSubstr("\"b\""), HasSubstr("\"c\"")));
}

TEST(Conditions, DescribeThemselves)
{
  const BodyModel body =
      test::makeBody(square(), 1, {{test::onSide("Roller", "left")}, {{"Body Force", {{"X", "1"}}}}});
  EXPECT_EQ(body.supports[0]->description(), "roller at left");
  EXPECT_EQ(body.loads[0]->description(), "body force");
}

TEST(Roller, RefusesABentSideAndSaysByHowMuch)
{
  EXPECT_THAT(refusal(withBentTop(10.0), {{test::onSide("Roller", "top")}, {}}),
              AllOf(HasSubstr("straight or flat"), HasSubstr("\"top\" turns by 10 degrees"), HasSubstr("Split")));
  EXPECT_THAT(refusal(withBentTop(0.01), {{test::onSide("Roller", "top")}, {}}), HasSubstr("turns by 0.01 degrees"));
}

TEST(Roller, TakesAStraightSideInAnyDirection)
{
  for (const double rotation : {0.0, 12.0, 45.0, 200.0})
    for (const char* side : {"left", "right", "bottom", "top"})
      EXPECT_NO_THROW(test::makeBody(square(rotation), 1, {{test::onSide("Roller", side)}, {}})) << rotation << side;
}

TEST(Roller, TakesASideWithTheRoundingOfAMeshFile)
{
  test::Random random(1);
  const Mesh rounded =
      test::moved(square(30.0), [&random](double* x) { x[0] += 1e-9 * random(), x[1] += 1e-9 * random(); });
  EXPECT_NO_THROW(test::makeBody(rounded, 1, {{test::onSide("Roller", "top")}, {}}));
}

TEST(Clamp, HoldsEveryComponentOfEveryNode)
{
  for (const auto& mesh : {square(), test::box({2, 2, 2})}) {
    const BodyModel body = test::makeBody(mesh, 2, {{test::onSide("Clamp", "left")}, {}});
    const ConstraintSet constraints = test::constraintsOf(body);
    EXPECT_EQ(constraints.nodes().size(), sideNodes(body.nodes, *body.side("left")).size());
    for (const auto& entry : constraints.nodes())
      EXPECT_EQ(entry.second.count, mesh.dim);
  }
}

TEST(Displacement, NeedsAComponent)
{
  EXPECT_THAT(refusal(square(), {{test::onSide("Displacement", "left")}, {}}),
              HasSubstr("prescribes no component; give at least one of X, Y, Z"));
}

TEST(Displacement, LeavesComponentsThatAreNotGivenFree)
{
  const BodyModel body =
      test::makeBody(test::box({1, 1, 1}), 1, {{with(test::onSide("Displacement", "top"), "Y", "x + 2*z")}, {}});
  const ConstraintSet constraints = test::constraintsOf(body);
  EXPECT_EQ(constraints.nodes().size(), 4u);
  for (const auto& [number, node] : constraints.nodes()) {
    EXPECT_EQ(node.count, 1);
    EXPECT_EQ(node.direction[0], (Direction{0, 1, 0}));
    EXPECT_EQ(node.value[0], body.nodes.point(number)[0] + 2.0);
  }
}

TEST(Displacement, RefusesZInThePlane)
{
  EXPECT_THAT(refusal(square(), {{with(test::onSide("Displacement", "left"), "Z", "0")}, {}}),
              HasSubstr("two-dimensional and has no z displacement"));
}

TEST(VectorLoads, RefuseZInThePlane)
{
  EXPECT_THAT(refusal(square(), {{}, {with(test::onSide("Traction", "left"), "Z", "1")}}),
              HasSubstr("two-dimensional and takes no load along z"));
  EXPECT_THAT(refusal(square(), {{}, {{"Body Force", {{"Z", "1"}}}}}),
              HasSubstr("two-dimensional and takes no load along z"));
}

TEST(Expressions, AValueThatIsNotFiniteIsReportedWithItsPoint)
{
  const BodyModel held =
      test::makeBody(square(), 1, {{with(test::onSide("Displacement", "bottom"), "X", "sqrt(0.5 - x)")}, {}});
  EXPECT_THAT(test::complaint([&] { test::constraintsOf(held); }),
              AllOf(HasSubstr("body.xml:"), HasSubstr("Supports/0"), HasSubstr("\"sqrt(0.5 - x)\" is"),
                    HasSubstr("nan at (0.75, 0)")));

  const auto loadMessage = [](const Mesh& mesh, const Condition& load) {
    const BodyModel body = test::makeBody(mesh, 1, {{}, {load}});
    return test::complaint([&] { assembleLoad(body, Frames(mesh.dim, body.nodes.numNodes())); });
  };
  EXPECT_THAT(loadMessage(square(), with(test::onSide("Pressure", "left"), "Value", "1/x")),
              AllOf(HasSubstr("Loads/0"), HasSubstr("\"1/x\" is inf at (0, ")));
  EXPECT_THAT(loadMessage(test::box({1, 1, 1}), with(test::onSide("Traction", "top"), "Z", "ln(z - 1)")),
              AllOf(HasSubstr("\"ln(z - 1)\""), HasSubstr(", 1)")));
  EXPECT_THAT(loadMessage(square(), {"Body Force", {{"Y", "sqrt(x - 2)"}}}), HasSubstr("nan at ("));
}

} // namespace ndframe
