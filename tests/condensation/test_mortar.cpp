// Contact in weighted means: what W and E promise, on sides that do not match.

#include <random>

#include <gtest/gtest.h>

#include "driver/scene.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// Cells of the foundation beside eight on the punch, order and conditions.
struct Sides
{
  std::string foundation, conditions;
  int order;
};

std::ostream& operator<<(std::ostream& out, const Sides& sides)
{
  return out << sides.foundation << ", " << sides.conditions << ", order " << sides.order;
}

Scene punch(const std::string& foundation)
{
  Scene scene("punch");
  for (const char* setting : {"Bodies/punch/Mesh/Cells={8, 4}", "Coupling/Type=Monolithic", "Output/Exodus=false",
                              "Bodies/foundation/Mesh/Pattern=Crossed", "Interfaces/contact/Pairing/Type=Mortar"})
    scene.set(setting);
  return std::move(scene.set("Bodies/foundation/Mesh/Cells=" + foundation));
}

class MortarOf : public testing::TestWithParam<Sides>
{
public:
  const Outcome outcome = punch(GetParam().foundation)
                              .set("Discretization/Contact Conditions=" + GetParam().conditions)
                              .set("Discretization/Order=" + std::to_string(GetParam().order))
                              .run();
  const InterfaceSystem& system = outcome.run.condensed.interface;

  Vector random(int size, unsigned seed) const
  {
    std::mt19937 generator(seed);
    Vector values;
    for (int i = 0; i < size; ++i)
      values.push_back(std::uniform_real_distribution<double>(-1.0, 1.0)(generator));
    return values;
  }

  /// A function of x on the side, as the unknowns have it.
  template <class Function>
  Vector atUnknowns(const Function& function) const
  {
    Vector values, result;
    const InterfaceMesh& side = outcome.run.model.interfaces.front();
    for (int i = 0; i < side.numNodes(); ++i)
      values.push_back(function(side.point(i)[0]));
    if (system.basis)
      values = system.basis->coefficients(values);
    for (const int node : system.nodeOfUnknown)
      result.push_back(values[std::size_t(node)]);
    return result;
  }
};

} // namespace

TEST_P(MortarOf, MeansOfFunctionsAreTheirCoefficients)
{
  ASSERT_NE(system.mortar, nullptr);
  EXPECT_LT(system.mortar->numConditions(), system.size());
  const Vector c = random(system.mortar->numConditions(), 1);
  EXPECT_LT(relativeDifference(system.mortar->meansOf(system.mortar->valuesAtUnknowns(c)), c), 1e-13);
}

/// Uniform pressure and its moments are among the tractions, so that no resultant is lost.
TEST_P(MortarOf, KeepsPolynomials)
{
  for (int degree = 0; degree <= GetParam().order; ++degree) {
    const Vector x = atUnknowns([&](double place) { return std::pow(place, degree); });
    EXPECT_LT(relativeDifference(system.mortar->valuesAtUnknowns(system.mortar->meansOf(x)), x), 1e-13);
  }
}

TEST_P(MortarOf, ForcesDoTheSameWork)
{
  const Vector f = random(system.mortar->numConditions(), 2), x = random(system.size(), 3);
  EXPECT_NEAR(dot(system.mortar->forcesAtUnknowns(f), x), dot(f, system.mortar->meansOf(x)), 1e-13);
  EXPECT_LT(relativeDifference(system.mortar->forcesOf(system.mortar->forcesAtUnknowns(f)), f), 1e-13);
}

/// W is the projection in L2: what it leaves is orthogonal to all functions.
TEST_P(MortarOf, IsAnL2Projection)
{
  const Vector x = random(system.size(), 4), projected = system.mortar->valuesAtUnknowns(system.mortar->meansOf(x));
  Vector rest = x;
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] -= projected[i];
  EXPECT_LT(largestEntry(system.mortar->forcesOf(system.forceOf(ofUnknowns(rest)))),
            1e-13 * largestEntry(system.mortar->forcesOf(system.forceOf(ofUnknowns(Vector(rest.size(), 1.0))))));
}

TEST_P(MortarOf, MeansAreClosedAndNothingPulls)
{
  EXPECT_LT(outcome.run.summary.residuals.penetration, 1e-12);
  EXPECT_LT(outcome.run.summary.residuals.complementarity, 1e-12);
  EXPECT_LT(outcome.run.summary.residuals.equilibrium, 1e-11);
  for (const ContactNode& node : outcome.run.solved.contact)
    EXPECT_GE(node.pressure, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Ratios, MortarOf,
                         testing::Values(Sides{"{24, 4}", "Nodal", 2}, Sides{"{24, 4}", "Bernstein", 2},
                                         Sides{"{24, 4}", "Nodal", 1}, Sides{"{12, 4}", "Nodal", 2},
                                         Sides{"{38, 4}", "Bernstein", 2}, Sides{"{38, 4}", "Nodal", 1}));

TEST(Mortar, IsNothingWhereSidesMatch)
{
  const Outcome cut = punch("{16, 4}").set("Interfaces/contact/Pairing/Type=Cut").run(), means = punch("{16, 4}").run();
  EXPECT_EQ(means.run.condensed.interface.mortar, nullptr);
  for (int body = 0; body < 2; ++body)
    EXPECT_EQ(displacement(means.run, body), displacement(cut.run, body));
}

/// In a scene with both pairings the unknowns of the other interface are conditions of their own, in every basis.
TEST(Mortar, LeavesOtherInterfacesAsTheyAre)
{
  for (const char* conditions : {"Nodal", "Bernstein"}) {
    const auto stack = [&](const char* pairing) {
      Scene scene("stack");
      scene.set("Bodies/middle/Mesh/Cells={6, 3}").set("Output/Exodus=false");
      scene.set(std::string("Discretization/Contact Conditions=") + conditions);
      return scene.set(std::string("Interfaces/upper on middle/Pairing/Type=") + pairing).run();
    };
    const Outcome outcome = stack("Mortar"), cut = stack("Cut");
    EXPECT_TRUE(outcome.run.failure.empty()) << outcome.run.failure;
    EXPECT_LT(outcome.run.summary.residuals.tension, 1e-12);
    EXPECT_NEAR(outcome.run.summary.energy / cut.run.summary.energy, 1.0, 1e-3);
    const InterfaceSystem& system = outcome.run.condensed.interface;
    ASSERT_NE(system.mortar, nullptr);
    const int others = outcome.run.model.interfaces.front().numNodes(); // "middle on lower"
    int found = 0;
    for (const SparseRow& mean : system.mortar->means())
      if (!mean.empty() && system.nodeOfUnknown[std::size_t(mean.front().first)] < others) {
        EXPECT_EQ(mean.size(), 1U);
        EXPECT_EQ(mean.front().second, 1.0);
        ++found;
      }
    EXPECT_EQ(found, others);
  }
}

/// Longer facets are halved first, and then there are vertices enough.
TEST(Mortar, IsNothingWhereOneSideIsThePartsOfTheOther)
{
  EXPECT_EQ(punch("{64, 4}").run().run.condensed.interface.mortar, nullptr);
}

TEST(Mortar, IsRefusedByNameWhereItMeansNothing)
{
  EXPECT_NE(complaintOf(punch("{24, 4}").set("Coupling/Type=Neumann-Dirichlet"))
                .find("does not ask for contact in means, as Pairing/Type = Mortar wants; use Monolithic"),
            std::string::npos);
  EXPECT_NE(complaintOf(Scene("blocks-3d").set("Interfaces/contact/Pairing/Type=Mortar")).find("for plane scenes"),
            std::string::npos);
  EXPECT_NE(complaintOf(Scene("rigid-cylinder").set("Interfaces/contact/Pairing/Type=Mortar")).find("is rigid and has"),
            std::string::npos);
  EXPECT_NE(complaintOf(Scene("flange").set("Interfaces/bond/Pairing/Type=Mortar")).find("where sides are tied"),
            std::string::npos);
}
