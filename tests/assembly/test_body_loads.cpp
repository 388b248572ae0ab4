// The integrals of loads in parts: who computes which part when must not show.

#include "ndframe/assembly/body_loads.hpp"

#include <numeric>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"
#include "ndframe/algebra/threads.hpp"

namespace ndframe
{
namespace
{

using Entries = std::vector<std::pair<std::string, std::string>>;

/// On 20 000 triangles, vertices in any order: loads that vary and a constant one, of several parts each.
BodyModel loaded(const Entries& force)
{
  return test::makeBody(
      test::renumbered(test::box({100, 100}), 3), 2,
      {{}, {{"Body Force", force}, {"Body Force", {{"X", "0.3"}}}, {"Pressure", {{"Side", "top"}, {"Value", "x^2"}}}}});
}

Vector integrated(const BodyModel& body, const std::vector<int>& order)
{
  BodyLoads loads(body, Load::Keep::Nothing);
  for (const int part : order)
    loads.compute(part);
  return loads.take();
}

double sum(const Vector& forces, std::size_t component)
{
  double total = 0.0;
  for (std::size_t i = component; i < forces.size(); i += 2)
    total += forces[i];
  return total;
}

} // namespace

TEST(BodyLoads, HaveTheSameBitsInWhateverOrderPartsAreComputed)
{
  const BodyModel body = loaded({{"X", "sin(5*x-y)"}, {"Y", "exp(x*y)"}});
  const Vector expected = integrateLoads(body);
  std::vector<int> order(std::size_t(BodyLoads(body, Load::Keep::Nothing).numParts()));
  ASSERT_GT(order.size(), 4U);
  std::iota(order.rbegin(), order.rend(), 0);
  EXPECT_EQ(integrated(body, order), expected);
  std::rotate(order.begin(), order.begin() + 3, order.end());
  EXPECT_EQ(integrated(body, order), expected);
  for (int round = 0; round < 3; ++round) {
    BodyLoads loads(body, Load::Keep::Nothing);
    runConcurrently(loads.numParts(), 3, [&](int part) { loads.compute(part); });
    EXPECT_EQ(loads.take(), expected);
  }
}

TEST(BodyLoads, AddUpToTheirResultants)
{
  const Vector forces = integrateLoads(loaded({{"X", "3*x^2"}, {"Y", "y > 0.25 ? 4 : 0"}}));
  EXPECT_NEAR(sum(forces, 0), 1.0 + 0.3, 1e-12);
  EXPECT_NEAR(sum(forces, 1), 3.0 - 1.0 / 3.0, 1e-12);
}

/// Every load that is not finite somewhere, once, whatever number of parts it fails in.
TEST(BodyLoads, NameAllThatAreNotFinite)
{
  BodyModel body = loaded({{"X", "1/(x-0.5)^2"}});
  body.loads[2] = std::move(
      test::makeBody(test::box({1, 1}), 2, {{}, {{"Pressure", {{"Side", "top"}, {"Value", "log(x-2)"}}}}}).loads[0]);
  try {
    integrateLoads(body);
    FAIL() << "it is finite";
  } catch (const InputError& error) {
    ASSERT_EQ(error.list().size(), 2U);
    EXPECT_THAT(error.list()[0].message, testing::HasSubstr("1/(x-0.5)^2"));
    EXPECT_THAT(error.list()[1].message, testing::HasSubstr("log(x-2)"));
  }
}

} // namespace ndframe
