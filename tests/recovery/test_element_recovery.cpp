#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "element_tractions.hpp"
#include "equilibrium/sample_stress.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"
#include "ndframe/mechanics/kernels.hpp"
#include "ndframe/simd/cell_distances.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{
namespace
{

using test::Conditions;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double roundOff = 1e-12;

struct Space
{
  int order, degree;
};

std::string spaceName(const testing::TestParamInfo<Space>& test)
{
  return "Order" + std::to_string(test.param.order) + "Degree" + std::to_string(test.param.degree);
}

StressCorrection recovered(const test::Problem& problem)
{
  return equilibrateElements(edgeMap(problem.body), problem.body, problem.data, problem.field());
}

test::Problem sample(const std::string& kind, Space space, const Elasticity& law = test::elastic(2),
                     double rotation = 0.0)
{
  BodyModel body = test::makeBody(test::sampleMesh(2, rotation), space.order, test::conditions(2, kind));
  body.laws = law;
  return test::solved(std::move(body), space.degree);
}

/// A displacement prescribed on all sides of a box.
Conditions prescribedEverywhere(const std::string& x, const std::string& y)
{
  Conditions conditions;
  for (const char* side : {"left", "right", "bottom", "top"}) {
    conditions.supports.push_back(test::onSide("Displacement", side));
    conditions.supports.back().entries.insert(conditions.supports.back().entries.end(), {{"X", x}, {"Y", y}});
  }
  return conditions;
}

/// Every length times `length`, every stress times `stress`, everything turned by `angle`: the same problem.
test::Problem seenOtherwise(test::Problem problem, double length, double stress, double angle)
{
  const auto turn = [angle](double* v, double factor) {
    const double x = v[0], y = v[1];
    v[0] = factor * (std::cos(angle) * x - std::sin(angle) * y);
    v[1] = factor * (std::sin(angle) * x + std::cos(angle) * y);
  };
  const auto turnAll = [&turn](std::vector<double>& values, double factor) {
    for (std::size_t i = 0; i < values.size(); i += 2)
      turn(values.data() + i, factor);
  };
  turnAll(problem.body.mesh.points, length);
  turnAll(problem.body.nodes.points, length);
  turnAll(problem.displacement, length);
  turnAll(problem.data.facetShares, stress * length);
  turnAll(problem.data.cellShares, stress * length);
  for (BoundaryFacet& facet : problem.data.boundary)
    for (Direction& direction : facet.directions)
      turn(direction.data(), 1.0);
  Elasticity law = problem.body.laws(0);
  for (double& entry : law.D)
    entry *= stress;
  problem.body.laws = law;
  return problem;
}

double boundOf(const test::Problem& problem)
{
  return std::sqrt(test::energyOf(problem.body, recovered(problem)));
}

} // namespace

struct Elements : testing::TestWithParam<Space>
{};

TEST_P(Elements, GiveEquilibriumWhateverTheConditions)
{
  for (const std::string& kind : test::conditionKinds())
    for (const Elasticity& law : test::sampleLaws(2))
      for (const double rotation : {0.0, 35.0}) {
        SCOPED_TRACE(fmt::format("{}, turned by {}, stiffnesses {}", kind, rotation, law(0, 0) / law(2, 2)));
        const auto problem = sample(kind, GetParam(), law, rotation);
        const auto correction = recovered(problem);
        // What u_h loses by rounding is multiplied by the bulk stiffness in its stress.
        const double tolerance = roundOff * std::max(1.0, 0.01 * law(0, 0) / law(2, 2));
        EXPECT_LT(checkEquilibrium(problem.body, problem.data, problem.field(), correction).largest(), tolerance);
        EXPECT_LT(correction.defect(), tolerance);
        EXPECT_GT(test::energyOf(problem.body, correction), 0.0);
      }
}

/// int_E c : eps(phi_i e_k) = 0 for all nodes of all cells: the condition that the tractions are made from.
TEST_P(Elements, WorkAgainstNodalFunctionsAsTheComputedStressDoes)
{
  const auto problem = sample("clamped", GetParam(), test::sampleLaws(2)[2]);
  const auto correction = recovered(problem);
  const Vector zero(problem.displacement.size(), 0.0);
  for (int cell = 0; cell < problem.body.mesh.numCells(); ++cell) {
    const SplitStress stress = equilibratedStress(problem.body, zero, correction, cell);
    Vector work(12, 0.0);
    double size = 0.0;
    test::overSubCells(2, GetParam().degree + 1, [&](int sub, const double* lambda, double weight) {
      double sigma[3], gradLambda[6], gradients[12], local[3], points[6], force[2];
      for (int v = 0; v < 3; ++v) {
        std::copy_n(problem.body.mesh.point(problem.body.mesh.cell(cell)[v]), 2, points + 2 * v);
        local[stress.cell.local[std::size_t(v)]] = lambda[v];
      }
      stress.stress(sub, lambda, sigma);
      barycentricGradients<2>(points, gradLambda);
      const int nodes = GetParam().order == 1 ? 3 : 6;
      GetParam().order == 1 ? Lagrange<2, 1>::gradients(local, gradLambda, gradients)
                            : Lagrange<2, 2>::gradients(local, gradLambda, gradients);
      for (int a = 0; a < nodes; ++a) {
        divergenceForce<2>(gradients + 2 * a, sigma, force);
        for (int k = 0; k < 2; ++k) {
          work[std::size_t(2 * a + k)] += weight * force[k];
          size += weight * std::abs(force[k]);
        }
      }
    });
    EXPECT_LT(test::largest(work), roundOff * size) << cell;
  }
}

TEST_P(Elements, LeaveAnExactStressAlone)
{
  const auto [order, degree] = GetParam();
  const Elasticity law = test::elastic(2);
  auto conditions = prescribedEverywhere("0.3*x - 0.1*y", "0.2*x + 0.5*y");
  if (order == 2) {
    conditions = prescribedEverywhere("0.5*x^2", "0.2*x");
    conditions.loads = {{"Body Force", {{"X", fmt::format("{}", -law(0, 0))}}}};
  }
  const auto problem = test::solved(test::makeBody(test::sampleMesh(2, 0.0), order, conditions), degree);
  const auto correction = recovered(problem);
  EXPECT_LT(test::energyOf(problem.body, correction),
            roundOff * roundOff * norm(cellDistances(problem.body, correction, &problem.displacement)));
}

TEST_P(Elements, DoNotSeeUnitsAndAxes)
{
  const auto problem = sample("pinched", GetParam());
  const double length = 1e-3, stress = 2e11, angle = 0.7;
  const auto other = seenOtherwise(sample("pinched", GetParam()), length, stress, angle);
  const double expected = boundOf(problem) * std::sqrt(stress) * length;
  EXPECT_NEAR(boundOf(other), expected, 1e-11 * expected);
}

TEST_P(Elements, DoNotSeeNumbering)
{
  const auto [order, degree] = GetParam();
  const Mesh mesh = test::sampleMesh(2, 0.0);
  const auto bound = [order = order, degree = degree](Mesh numbered) {
    return boundOf(test::solved(test::makeBody(std::move(numbered), order, test::conditions(2, "corner")), degree));
  };
  const double expected = bound(mesh);
  EXPECT_NEAR(bound(test::renumbered(mesh, 4)), expected, 1e-11 * expected);
}

/// The same pressure as a load and as the traction of a contact facet.
TEST_P(Elements, CarryTractionsOfContactAsLoads)
{
  const auto [order, degree] = GetParam();
  Conditions conditions{{test::onSide("Clamp", "left"), test::onSide("Roller", "top")},
                        {test::onSide("Pressure", "right")}};
  conditions.loads[0].entries.emplace_back("Value", "0.4");
  const auto problem = test::solved(test::makeBody(test::sampleMesh(2, 20.0), order, conditions), degree);

  std::vector<ContactPatch> patches;
  std::vector<Facet> contact;
  for (const Facet facet : problem.body.side("right")->facets) {
    ContactPatch common;
    common.sides = {{{0, facet}, {1, facet}}}; // a copy of the body, seen from the other side
    common.measure = facetNormal(problem.body.mesh, facet, common.normal.data());
    common.nodes = {0, 0, 0};
    patches.push_back(common);
    contact.push_back(facet);
  }
  BodyModel unloaded = test::makeBody(test::sampleMesh(2, 20.0), order, {conditions.supports, {}});
  const StaticData data = makeStaticData(unloaded, degree, contact);
  SceneField field{{&problem.displacement, &problem.displacement},
                   tractionFromNodes(patches, {-0.4}, order, degree),
                   tractionFromNodes(patches, {0.4}, order, degree),
                   false,
                   {}};
  Ledger ledger;
  const auto recovery = test::makeRecovery("Element", {{"Degree", degree}});
  const auto stresses =
      recovery->recover({{&unloaded, &unloaded}, {data, data}, patches}, {field, field}, test::comm(), ledger);
  const auto expected = recovered(problem);
  ASSERT_EQ(stresses.size(), 2u);
  for (const SceneStress& stress : stresses) {
    EXPECT_EQ(stress.tractions[0].shares, field.tractions[0].shares);
    for (const StressCorrection& correction : stress.corrections)
      EXPECT_LT(norm(test::difference(correction.tractions, expected.tractions)), roundOff * norm(expected.tractions));
  }
  EXPECT_EQ(ledger.counted("element problems"), 4 * unloaded.mesh.numCells());
}

INSTANTIATE_TEST_SUITE_P(AllSpaces, Elements, testing::Values(Space{1, 1}, Space{1, 2}, Space{2, 2}, Space{2, 3}),
                         spaceName);

TEST(ElementRecovery, ReportsAStressThatIsNotInEquilibrium)
{
  auto problem = sample("clamped", {2, 2});
  problem.displacement[problem.displacement.size() / 2] += 1e-3 * test::largest(problem.displacement);
  EXPECT_GT(recovered(problem).defect(), 1e-4);
}

TEST(ElementRecovery, RefusesAMeshThatTouchesItselfInAPoint)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0, 1, 0, 0, 1, -1, 0, 0, -1};
  mesh.cells = {0, 1, 2, 0, 3, 4};
  const BodyModel body = test::makeBody(mesh, 1);
  EXPECT_THAT(test::complaint([&] { edgeMap(body); }),
              AllOf(HasSubstr("touches itself at the point (0, 0) only"), HasSubstr("share a facet")));
}

TEST(ElementRecovery, SaysWhatItIsNotDefinedFor)
{
  const auto recovery = test::makeRecovery("Element");
  EXPECT_EQ(recovery->degree(2), 2);
  EXPECT_THAT(recovery->refusal(2, 2, false), IsEmpty());
  EXPECT_THAT(recovery->refusal(3, 2, false), HasSubstr("two dimensions only; choose Type Automatic"));
  EXPECT_THAT(recovery->refusal(2, 1, true), HasSubstr("Interface Traction/Type Projected"));
  EXPECT_THAT(test::makeRecovery("Element", {{"Degree", 1}})->refusal(2, 2, false),
              HasSubstr("Degree = 1 does not suit displacements of order 2; it may be 2 or 3"));
  EXPECT_THAT(test::makeRecovery("Element", {{"Degree", 3}})->refusal(2, 1, false), HasSubstr("it may be 1 or 2"));
}

} // namespace ndframe
