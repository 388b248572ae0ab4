#include <cmath>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"

namespace ndframe
{

namespace
{

using testing::AllOf;
using testing::HasSubstr;

Direction randomDirection(test::Random& random, int dim)
{
  Direction d{};
  for (int k = 0; k < dim; ++k)
    d[std::size_t(k)] = random();
  const double size = std::sqrt(dotProduct(d, d));
  for (double& component : d)
    component /= size;
  return d;
}

void expectOrthonormal(const ConstraintSet::Node& node)
{
  for (std::size_t i = 0; i < std::size_t(node.count); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      EXPECT_NEAR(dotProduct(node.direction[i], node.direction[j]), i == j ? 1.0 : 0.0, 1e-12);
}

/// The displacement that a fully held node has.
Direction displacementOf(const ConstraintSet::Node& node)
{
  Direction u{};
  for (std::size_t k = 0; k < std::size_t(node.count); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      u[i] += node.value[k] * node.direction[k][i];
  return u;
}

test::Condition displacement(const std::string& side, const std::string& component, const std::string& value)
{
  return {"Displacement", {{"Side", side}, {component, value}}};
}

} // namespace

TEST(ConstraintSet, ReducesConstraintsToOrthonormalDirectionsWithTheirValues)
{
  test::Random random(1);
  for (const int dim : {2, 3})
    for (int sample = 0; sample < 20; ++sample) {
      const Direction u = {random(), random(), dim == 3 ? random() : 0.0};
      ConstraintSet set(dim, 1.0);
      std::vector<Direction> given;
      for (int k = 0; k < dim; ++k) {
        given.push_back(randomDirection(random, dim));
        ASSERT_TRUE(set.add({5, given.back(), dotProduct(u, given.back())}));
        expectOrthonormal(set.nodes().at(5));
        EXPECT_EQ(set.nodes().at(5).count, k + 1);
      }
      const Direction computed = displacementOf(set.nodes().at(5));
      for (const auto& direction : given)
        EXPECT_NEAR(dotProduct(computed, direction), dotProduct(u, direction), 1e-11);
    }
}

TEST(ConstraintSet, AgreesWithWhatItKnowsAndRefusesAContradiction)
{
  test::Random random(2);
  ConstraintSet set(2, 1.0);
  const Direction u = {0.3, -0.2, 0.0};
  for (const Direction& d : {Direction{0.6, 0.8, 0.0}, Direction{1.0, 0.0, 0.0}})
    EXPECT_TRUE(set.add({0, d, dotProduct(u, d)}));
  const Direction third = randomDirection(random, 2);
  EXPECT_TRUE(set.add({0, third, dotProduct(u, third)}));
  EXPECT_FALSE(set.add({0, third, dotProduct(u, third) + 1e-9}));
  EXPECT_TRUE(set.add({1, third, 7.0})) << "another node";
  EXPECT_EQ(set.nodes().at(0).count, 2);
}

TEST(ConstraintSet, ComparesDisplacementsWithTheSizeOfTheBody)
{
  for (const double length : {1e-6, 1.0, 1e6}) {
    ConstraintSet set(2, length);
    EXPECT_TRUE(set.add({0, {1, 0, 0}, 0.1 * length}));
    EXPECT_TRUE(set.add({0, {1, 0, 0}, (0.1 + 1e-14) * length}));
    EXPECT_FALSE(set.add({0, {1, 0, 0}, (0.1 + 1e-9) * length}));
  }
}

TEST(ConstraintSet, OppositeDirectionsAreOne)
{
  ConstraintSet set(3, 1.0);
  EXPECT_TRUE(set.add({0, {0, 0, 1}, 0.5}));
  EXPECT_TRUE(set.add({0, {0, 0, -1}, -0.5}));
  EXPECT_FALSE(set.add({0, {0, 0, -1}, 0.5}));
  EXPECT_EQ(set.nodes().at(0).count, 1);
}

TEST(ConstraintSet, DirectionsThatDifferByTheRoundingOfAMeshFileAreOne)
{
  ConstraintSet set(2, 1.0);
  const double rounding = 1e-6;
  EXPECT_TRUE(set.add({0, {std::cos(0.5), std::sin(0.5), 0}, 0.0}));
  EXPECT_TRUE(set.add({0, {std::cos(0.5 + rounding), std::sin(0.5 + rounding), 0}, 0.0}));
  EXPECT_EQ(set.nodes().at(0).count, 1);
  EXPECT_EQ(set.freePart(0, {std::cos(0.5 + rounding), std::sin(0.5 + rounding), 0}), Direction{});
}

TEST(ConstraintSet, FreePartIsWhatTheKnownDirectionsLeave)
{
  test::Random random(3);
  ConstraintSet set(3, 1.0);
  const Direction d = randomDirection(random, 3), known = randomDirection(random, 3);
  EXPECT_EQ(set.freePart(0, d), d);
  set.add({0, known, 0.0});
  const Direction rest = set.freePart(0, d);
  EXPECT_NEAR(dotProduct(rest, known), 0.0, 1e-15);
  EXPECT_NEAR(dotProduct(rest, rest), 1.0 - std::pow(dotProduct(d, known), 2), 1e-14);
  EXPECT_EQ(set.freePart(0, known), Direction{});
}

TEST(CollectConstraints, InclinedRollersHoldTheirCornerFully)
{
  const BodyModel body = test::makeBody(test::box({2, 2}, "Right", 20.0), 2,
                                        {{test::onSide("Roller", "left"), test::onSide("Roller", "bottom")}, {}});
  const ConstraintSet set = test::constraintsOf(body);
  EXPECT_EQ(set.nodes().size(), 9u);
  const double angle = 20.0 * M_PI / 180.0;
  for (const auto& [number, node] : set.nodes()) {
    const auto x = body.nodes.point(number);
    expectOrthonormal(node);
    EXPECT_EQ(node.count, x[0] == 0.0 && x[1] == 0.0 ? 2 : 1);
    const bool onBottom = std::abs(-x[0] * std::sin(angle) + x[1] * std::cos(angle)) < 1e-12;
    if (node.count == 1) {
      EXPECT_NEAR(std::abs(node.direction[0][0]), onBottom ? std::sin(angle) : std::cos(angle), 1e-14);
    }
  }
}

TEST(CollectConstraints, SupportsThatAgreeWhereTheyMeetAreFine)
{
  const BodyModel body = test::makeBody(
      test::box({2, 2}), 1,
      {{test::onSide("Clamp", "left"), displacement("bottom", "X", "0.1*x"), test::onSide("Roller", "left")}, {}});
  const ConstraintSet set = test::constraintsOf(body);
  int held = 0;
  for (const auto& [number, node] : set.nodes()) {
    held += node.count;
    if (body.nodes.point(number)[1] == 0.0) {
      EXPECT_EQ(displacementOf(node)[0], 0.1 * body.nodes.point(number)[0]);
    }
  }
  EXPECT_EQ(held, 3 * 2 + 2);
}

TEST(CollectConstraints, AContradictionNamesBothSupportsAndThePoint)
{
  const test::Conditions conditions{
      {test::onSide("Roller", "right"), test::onSide("Clamp", "left"), displacement("bottom", "X", "0.1 + x")}, {}};
  const BodyModel body = test::makeBody(test::box({2, 2}), 1, conditions);
  EXPECT_THAT(test::complaint([&] { test::constraintsOf(body); }),
              AllOf(HasSubstr("body.xml:"), HasSubstr("Supports/2: contradicts Supports/1 (clamp at left) at (0, 0)"),
                    testing::Not(HasSubstr("Supports/0"))));
}

TEST(CollectConstraints, AllContradictionsAreReportedAtOnce)
{
  const test::Conditions conditions{{test::onSide("Clamp", "left"), displacement("bottom", "X", "1"),
                                     displacement("top", "Y", "1"), displacement("right", "Y", "0")},
                                    {}};
  const BodyModel body = test::makeBody(test::box({2, 2}), 1, conditions);
  EXPECT_THAT(test::complaint([&] { test::constraintsOf(body); }),
              AllOf(HasSubstr("Supports/1: contradicts Supports/0 (clamp at left) at (0, 0)"),
                    HasSubstr("Supports/2: contradicts Supports/0 (clamp at left) at (0, 1)"),
                    HasSubstr("Supports/3: contradicts Supports/2 (displacement at top) at (1, 1)")));
}

} // namespace ndframe
