#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "equilibrium/sample_stress.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/equilibrium_check.hpp"

namespace ndframe
{
namespace
{

using test::StressKind;

Mesh sampleMesh(int dim)
{
  return test::renumbered(test::shaken(test::box(std::vector<int>(std::size_t(dim), 2)), 0.1, 2), 3);
}

/// Moments of a facet's traction.
const double* tractionsOf(const StressCorrection& moments, const Mesh& mesh, Facet facet)
{
  const int perFacet = facetBasis(mesh.dim, moments.degree).size() * mesh.dim;
  return moments.tractions.data() + (facet.cell * (mesh.dim + 1) + sortedFacet(mesh, facet)) * perFacet;
}

/// Appends the moments as shares of `vertices` vertices, not all alike.
void appendShares(std::vector<double>& shares, const double* moments, int size, int vertices)
{
  for (int a = 0; a < vertices; ++a)
    for (int i = 0; i < size; ++i)
      shares.push_back(moments[i] * 2.0 * (a + 1.0) / (vertices * (vertices + 1.0)));
}

/// A body in which a polynomial stress rules: sigma^ = K eps(u~) + c is equilibrated with it up to bubbles.
struct Equilibrium
{
  BodyModel body;
  StaticData data;
  Vector displacement;
  Vector contact;
  StressCorrection correction;

  explicit Equilibrium(const StressKind& kind, unsigned seed = 5)
      : Equilibrium(kind, sampleMesh(kind.dim), test::polynomialStress(kind.dim, kind.degree, seed))
  {}
  Equilibrium(const StressKind& kind, Mesh mesh, const test::StressField& field)
      : body(test::bodyOf(std::move(mesh), std::min(2, kind.degree), test::sampleLaws(kind.dim)[2]))
  {
    const StressCorrection whole = test::momentsOf(field, body.mesh, kind.degree);
    const test::ElasticField elastic = test::elasticField(body.laws(0), body.nodes.order, 7);
    displacement = test::interpolate(body.nodes, elastic.displacement);
    correction = test::momentsOf(elastic.stress, body.mesh, kind.degree);
    correction.tractions = test::difference(whole.tractions, correction.tractions);
    correction.loads = test::difference(whole.loads, correction.loads);
    data.dim = kind.dim;
    data.order = body.nodes.order;
    data.degree = kind.degree;
    const int facetSize = facetBasis(kind.dim, kind.degree).size() * kind.dim;
    for (const Side& side : body.mesh.sides)
      for (const Facet& facet : side.facets) {
        data.boundary.push_back({facet, 0, {}});
        appendShares(data.facetShares, tractionsOf(whole, body.mesh, facet), facetSize, kind.dim);
      }
    const int loadSize = loadBasis(kind.dim, kind.degree).size() * kind.dim;
    for (int c = 0; c < body.mesh.numCells(); ++c)
      appendShares(data.cellShares, whole.loads.data() + c * loadSize, loadSize, kind.dim + 1);
    for (double& share : data.cellShares)
      share = -share;
  }

  EquilibriumDefects check() const
  {
    return checkEquilibrium(body, data, {&displacement, contact.empty() ? nullptr : &contact}, correction);
  }
  /// The shares of boundary facet i.
  double* sharesOf(int i) { return data.facetShares.data() + std::size_t(i) * perFacet(); }
  std::size_t perFacet() const { return data.facetShares.size() / data.boundary.size(); }
};

constexpr double roundOff = 1e-10;

} // namespace

TEST(EquilibriumCheck, FindsNoDefectInAnEquilibratedStress)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    EXPECT_LT(Equilibrium(kind).check().largest(), roundOff);
  }
}

TEST(EquilibriumCheck, SeesAWrongTraction)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    Equilibrium scene(kind);
    scene.sharesOf(1)[kind.dim] += 1e-3; // moment of mode 1
    const EquilibriumDefects defects = scene.check();
    EXPECT_GT(defects.loads, 1e-6);
    EXPECT_EQ(defects.largest(), defects.loads);
    EXPECT_LT(std::max(defects.divergence, std::max(defects.jumps, defects.interior)), roundOff);
  }
}

TEST(EquilibriumCheck, MeasuresATractionAgainstTheLargestStress)
{
  // A uniform tension of 4 that carries a traction of 3 on one side.
  const auto tension = [](const double*, double* sigma) { sigma[0] = 4.0, sigma[1] = sigma[2] = 0.0; };
  Equilibrium scene({2, 2}, test::box({2, 2}), tension);
  for (std::size_t i = 0; i < scene.data.boundary.size(); ++i)
    for (std::size_t k = 0; k < scene.perFacet(); ++k)
      scene.sharesOf(int(i))[k] *= 0.75;
  EXPECT_NEAR(scene.check().loads, 0.25, 1e-12);
}

TEST(EquilibriumCheck, SeesAWrongBodyForce)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    Equilibrium scene(kind);
    scene.data.cellShares[0] += 1e-3;
    const EquilibriumDefects defects = scene.check();
    EXPECT_GT(defects.divergence, 1e-6);
    EXPECT_LT(std::max(defects.loads, std::max(defects.jumps, defects.interior)), roundOff);
    scene.data.cellShares.clear();
    EXPECT_GT(scene.check().divergence, 1e-3);
  }
}

TEST(EquilibriumCheck, SeesAJumpBetweenCells)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    Equilibrium scene(kind);
    // Balanced moments added to the first cell, found by a polynomial stress.
    const StressCorrection other =
        test::momentsOf(test::polynomialStress(kind.dim, 0, 8), scene.body.mesh, kind.degree);
    const std::size_t perCell = other.tractions.size() / std::size_t(scene.body.mesh.numCells());
    for (std::size_t i = 0; i < perCell; ++i)
      scene.correction.tractions[i] += 1e-3 * other.tractions[i];
    const EquilibriumDefects defects = scene.check();
    EXPECT_GT(defects.jumps, 1e-6);
    EXPECT_LT(std::max(defects.divergence, defects.interior), roundOff);
  }
}

TEST(EquilibriumCheck, TakesFacetsThatAreNotListedAsFree)
{
  Equilibrium scene({2, 2});
  scene.data.facetShares.resize(scene.data.facetShares.size() - scene.perFacet());
  scene.data.boundary.pop_back();
  EXPECT_GT(scene.check().loads, 1e-3);
}

TEST(EquilibriumCheck, LeavesReactionsToSupports)
{
  for (const StressKind& kind : {StressKind{2, 2}, StressKind{3, 1}}) {
    SCOPED_TRACE(kind.name());
    Equilibrium scene(kind);
    scene.data.boundary[2].supported = 1;
    scene.data.boundary[2].directions[0] = {0.6, 0.8, 0.0};
    double* share = scene.sharesOf(2);
    share[0] += 0.6;
    share[1] += 0.8;
    EXPECT_LT(scene.check().loads, roundOff);
    share[0] += 0.8;
    share[1] -= 0.6;
    EXPECT_GT(scene.check().loads, 1e-3);
    scene.data.boundary[2].supported = 2;
    scene.data.boundary[2].directions[1] = {0.8, -0.6, 0.0};
    EXPECT_LT(scene.check().loads, roundOff);
  }
}

TEST(EquilibriumCheck, AddsTheTractionOfContact)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    Equilibrium scene(kind);
    // The first facet's load becomes contact, the second keeps a half as a load.
    for (int i = 0; i < 2; ++i) {
      double* share = scene.sharesOf(i);
      scene.data.contact.push_back(scene.data.boundary[std::size_t(i)].facet);
      for (std::size_t k = 0; k < scene.perFacet(); ++k) {
        scene.contact.push_back(share[k] * (i == 0 ? 1.0 : 0.5));
        share[k] -= scene.contact.back();
      }
    }
    EXPECT_LT(scene.check().loads, roundOff);
    scene.contact[0] *= 1.1;
    EXPECT_GT(scene.check().loads, 1e-6);
    scene.contact.clear();
    EXPECT_GT(scene.check().loads, 1e-3);
  }
}

TEST(EquilibriumCheck, DoesNotDependOnUnits)
{
  const double length = 1e-3, stress = 1e9;
  const StressKind kind{2, 3};
  Equilibrium scene(kind);
  scene.sharesOf(0)[0] += 0.01;
  const double defect = scene.check().loads;
  for (double& x : scene.body.mesh.points)
    x *= length;
  Elasticity law = scene.body.laws(0);
  for (double& entry : law.D)
    entry *= stress;
  scene.body.laws = law;
  for (double& u : scene.displacement)
    u *= length;
  for (std::vector<double>* forces :
       {&scene.data.facetShares, &scene.data.cellShares, &scene.correction.tractions, &scene.correction.loads})
    for (double& force : *forces)
      force *= stress * length;
  EXPECT_NEAR(scene.check().loads / defect, 1.0, 1e-9);
  EXPECT_LT(scene.check().divergence, roundOff);
}

TEST(EquilibriumCheck, FindsNothingWhereNothingActs)
{
  Equilibrium scene({2, 2}, test::box({1, 1}), [](const double*, double* sigma) { std::fill(sigma, sigma + 3, 0.0); });
  for (Vector* values : {&scene.displacement, &scene.correction.tractions, &scene.correction.loads})
    values->assign(values->size(), 0.0);
  EXPECT_EQ(scene.check().largest(), 0.0);
}

TEST(EquilibriumCheck, RefusesStressesThatAreNotNumbers)
{
  Equilibrium scene({2, 2});
  scene.correction.tractions[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.check(), InternalError);
}

} // namespace ndframe
