#include <gtest/gtest.h>

#include "base/sample_spec.hpp"
#include "ndframe/base/registry.hpp"

using namespace ndframe;

namespace
{

struct Shape
{
  virtual ~Shape() = default;
  virtual double area() const = 0;
};

struct Square final : Shape
{
  explicit Square(double side_) : side(side_) {}
  double area() const override { return side * side; }
  double side;
};

Registry<Shape> shapes()
{
  Registry<Shape> registry("shape", "Square");
  registry.add("Square", "Four equal sides.", {{"Side", 2.0, above(0.0), "Length."}},
               [](const Params& p) { return std::make_unique<Square>(p.get<double>("Side")); });
  return registry;
}

ListSpec shapeDeck(const Registry<Shape>& registry)
{
  ListSpec spec;
  spec.choices = registry.choices();
  return spec;
}

} // namespace

TEST(Registry, BuildsWhatTypeNames)
{
  const auto registry = shapes();
  const std::string deck = R"(<ParameterList><Parameter name="Side" type="double" value="3"/></ParameterList>)";
  EXPECT_EQ(registry.build(test::validated(deck, shapeDeck(registry)))->area(), 9.0);
  EXPECT_EQ(registry.build(test::validated("<ParameterList/>", shapeDeck(registry)))->area(), 4.0);
}

TEST(Registry, BuildsFromSettingsWithoutADeck)
{
  const auto registry = shapes();
  EXPECT_EQ(registry.build({"Type=Square", "Side=3"})->area(), 9.0);
  EXPECT_EQ(registry.build({"Side=5"})->area(), 25.0);
  EXPECT_EQ(registry.validated({"Type=Square"}).get<double>("Side"), 2.0);
  EXPECT_THROW(registry.build({"Type=Square", "Side=-1"}), InputError);
  EXPECT_THROW(registry.build({"Type=Squar"}), InputError);
}

TEST(Registry, CallsASecondRegistrationABug)
{
  auto registry = shapes();
  EXPECT_THROW(registry.add("Square", "Again.", {}, nullptr), InternalError);
}

TEST(Registry, CallsAComponentThatOnlyTheSpecKnowsABug)
{
  auto other = shapes();
  other.add("Circle", "Round.", {}, nullptr);
  const std::string deck = R"(<ParameterList><Parameter name="Type" type="string" value="Circle"/></ParameterList>)";
  EXPECT_THROW(shapes().build(test::validated(deck, shapeDeck(other))), InternalError);
}
