// The finer solution that errors are measured against, and the distances it gives.

#include "reference_solution.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contact_scene.hpp"
#include "driver/scene.hpp"
#include "fem/sample_meshes.hpp"
#include "fine_traction.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/fem/prolongation.hpp"
#include "ndframe/mesh/refine.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A deck's model and solutions on its meshes refined so many times.
struct Scenery
{
  SceneSettings settings;
  Model model;

  explicit Scenery(const Scene& scene) : settings(readScene(scene.params())), model(buildModel(settings, components()))
  {}

  ReferenceSolution solve(int refinements) const
  {
    return {settings, components(), model, refinements, Comm::single()};
  }
  std::vector<NodalField> zero() const
  {
    std::vector<NodalField> fields;
    for (const auto& body : model.bodies)
      fields.emplace_back(IndexMap::whole(body.nodes.numNodes()), body.mesh.dim);
    return fields;
  }
  ReferenceSummary compare(const std::vector<NodalField>& u, const ReferenceDepth& depth) const
  {
    Ledger ledger;
    std::shared_ptr<const ReferenceSolution> reference;
    updateReference(reference, settings, components(), model, depth, Comm::single(), ledger);
    return compareWithReference(reference.get(), model, u, nullptr, depth);
  }
};

Scene punch(int n)
{
  Scene scene("punch");
  scene.set(fmt::format("Bodies/punch/Mesh/Cells={{{0}, {0}}}", n));
  return scene.set(fmt::format("Bodies/foundation/Mesh/Cells={{{}, {}}}", 2 * n, n));
}

Scene beam(int order)
{
  return Scene("beam-3d").set("Bodies/beam/Mesh/Cells={4, 2, 1}").set(fmt::format("Discretization/Order={}", order));
}

/// The meshes of all bodies.
std::vector<Mesh> meshesOf(const Model& model)
{
  std::vector<Mesh> meshes;
  for (const auto& body : model.bodies)
    meshes.push_back(body.mesh);
  return meshes;
}

} // namespace

TEST(Reference, IsTheSolutionOnTheRefinedMesh)
{
  const Scenery coarse(punch(2)), fine(punch(4));
  const ReferenceSolution reference = coarse.solve(1), direct = fine.solve(0);
  EXPECT_EQ(reference.dofs(), direct.dofs());
  EXPECT_NEAR(reference.distance(coarse.zero()), direct.distance(fine.zero()), 1e-12);
}

/// |u_ref - u_h|^2 = |u_ref|^2 - |u_h|^2 for nested spaces without contact conditions that change.
TEST(Reference, DistanceObeysPythagorasInALinearScene)
{
  const Scenery scenery(Scene("beam-3d")
                            .set("Bodies/beam/Mesh/Cells={4, 2, 1}")
                            .set("Discretization/Order=1")
                            .set("Bodies/beam/Supports/root/Y=0")
                            .set("Bodies/beam/Supports/root/Z=0"));
  const auto u = scenery.solve(0).displacement();
  const ReferenceSolution reference = scenery.solve(2);
  const double norm = reference.norm(u), size = reference.distance(scenery.zero());
  EXPECT_NEAR(std::pow(reference.distance(u), 2), size * size - norm * norm, 1e-10 * size * size);
  EXPECT_GT(reference.distance(u), 0.1 * size);
}

TEST(Reference, FindsNoErrorInAnExactSolution)
{
  const Scenery scenery(beam(2));
  const auto u = scenery.solve(0).displacement();
  const ReferenceSolution reference = scenery.solve(1);
  EXPECT_LT(reference.distance(u), 1e-7 * reference.norm(u)); // the square root of round-off
  EXPECT_NEAR(std::pow(reference.norm(u), 2) * 600, 1.0, 1e-10);
}

/// The exact stress is known and in equilibrium: |sigma_ref - sigma|^2 = |u_ref - u|^2 = 0 whatever u^ is compared on
/// the way, and D = |u - u^|.
TEST(Reference, StressDistanceIsThatOfTheExactStress)
{
  const Scenery scenery(Scene("patch")
                            .set("Coupling/Type=Monolithic")
                            .set("Bodies/upper/Mesh/Cells={2, 2}")
                            .set("Bodies/lower/Mesh/Cells={2, 3}"));
  const ReferenceSolution exact = scenery.solve(0), reference = scenery.solve(2);
  const auto patches = contactPatches(scenery.model);
  ContactTraction pressure{2, Vector(patches.size() * 6, 0.0)};
  for (std::size_t f = 0; f < patches.size(); ++f)
    pressure.shares[f * 6] = -patches[f].measure; // t_N = -1
  // Any u^ will do that keeps the supports: their dofs, x = 0 and y = -1, are left alone.
  Random random(7);
  auto admissible = exact.displacement();
  for (std::size_t b = 0; b < admissible.size(); ++b)
    for (int i = 0; i < scenery.model.bodies[b].nodes.numNodes(); ++i)
      if (const auto x = scenery.model.bodies[b].nodes.point(i); x[0] > 0.1 && x[1] > -0.9)
        for (std::size_t k = 0; k < 2; ++k)
          admissible[b][std::size_t(i) * 2 + k] += 0.1 * random();
  const double D = exact.distance(admissible);
  EXPECT_GT(D, 0.5);
  EXPECT_LT(reference.stressDistance(scenery.model, admissible, patches, pressure, D), 1e-6 * D);
}

/// The work of a traction is the same on the facets of the mesh and on those of the refined mesh.
TEST(Reference, TractionsOnFinePatchesAreTheSamePolynomials)
{
  const Scenery scenery(punch(3));
  const Model fine = buildModel(scenery.settings, components(), [&](const BodySettings& body) {
    return refineUniformly(refineUniformly(meshesOf(scenery.model)[std::size_t(scenery.model.bodyIndex(body.name))]));
  });
  const auto patches = contactPatches(scenery.model), finePatches = contactPatches(fine);
  Random random(5);
  std::vector<NodalField> u, fineU;
  std::vector<const BodyModel*> bodies, fineBodies;
  for (std::size_t b = 0; b < 2; ++b) {
    const BodyModel& body = scenery.model.bodies[b];
    const NodeMap middle = makeNodeMap(refineUniformly(body.mesh), 2);
    u.push_back(atNodes(random.vector(std::size_t(body.numDofs())), 2));
    fineU.push_back(atNodes(prolongate(middle, fine.bodies[b].nodes, prolongate(body.nodes, middle, u[b])), 2));
    bodies.push_back(&body);
    fineBodies.push_back(&fine.bodies[b]);
  }
  for (const int degree : {2, 3}) {
    const ContactTraction t{degree, random.vector(patches.size() * 2 * std::size_t(degree + 1))};
    const ContactTraction fineT = onFinePatches(scenery.model, patches, t, fine, finePatches);
    const auto work = contactContributions(patches, t, jumpMoments(bodies, patches, u, degree));
    const auto fineWork = contactContributions(finePatches, fineT, jumpMoments(fineBodies, finePatches, fineU, degree));
    for (std::size_t f = 0; f < patches.size(); ++f) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k)
        sum += fineWork[4 * f + k];
      EXPECT_NEAR(sum, work[f], 1e-12 * std::abs(work[f]) + 1e-12);
    }
  }
}

TEST(Reference, DoesNotDependOnCouplingOrSolver)
{
  const Scenery monolithic(punch(2).set("Coupling/Type=Monolithic"));
  const Scenery relaxed(punch(2).set("Coupling/Stopping/Tolerance=0.9"));
  const Scenery krylov(punch(2).set("Linear Solver/Type=Krylov"));
  const auto zero = monolithic.zero();
  const double size = monolithic.solve(1).distance(zero);
  EXPECT_DOUBLE_EQ(relaxed.solve(1).distance(zero), size);
  EXPECT_NEAR(krylov.solve(1).distance(zero), size, 1e-7 * size);
}

/// Pairing allows 1e-5 of the shortest facet; the reference must not refuse what the run has accepted.
TEST(Reference, AcceptsSidesThatMatchLooselyOnTheCoarseMesh)
{
  Scenery scenery(punch(2));
  auto meshes = meshesOf(scenery.model);
  for (double& x : meshes[1].points)
    x += 2e-6;
  scenery.model = buildModel(scenery.settings, components(), [&](const BodySettings& body) {
    return meshes[std::size_t(scenery.model.bodyIndex(body.name))];
  });
  EXPECT_NEAR(scenery.solve(3).distance(scenery.zero()), 1.26, 0.02);
}

/// In a linear scene |sigma_ref - sigma^|^2 + |u_ref - u_h|^2 = D^2 (Prager and Synge), so the mean of the two stresses
/// misses sigma_ref by D/2 exactly, on whatever mesh the reference lives.
TEST(Reference, ObeysTheHypercircleInALinearScene)
{
  Scene scene("punch");
  scene.deck().lists.erase(std::remove_if(scene.deck().lists.begin(), scene.deck().lists.end(),
                                          [](const DeckList& list) { return list.name == "Interfaces"; }),
                           scene.deck().lists.end());
  scene.set("Bodies/punch/Mesh/Cells={3, 3}").set("Bodies/foundation/Mesh/Cells={4, 3}");
  scene.set("Bodies/punch/Supports/held/Type=Clamp").set("Bodies/punch/Supports/held/Side=bottom");
  scene.set("Bodies/foundation/Loads/push/Type=Traction").set("Bodies/foundation/Loads/push/Side=contact");
  scene.set("Bodies/foundation/Loads/push/X=x").set("Bodies/foundation/Loads/push/Y=-1");
  scene.set("Error Estimation/Estimators={Global, Reference}").set("Error Estimation/Reference/Refinements=2");
  const auto errors = scene.run().run.summary.errors.value();
  const auto& reference = errors.reference.value();
  const double D = errors.global->elements;
  EXPECT_NEAR((std::pow(*reference.stress, 2) + std::pow(reference.displacement, 2)) / (D * D), 1.0, 1e-9);
  EXPECT_NEAR(*reference.meanStress / (0.5 * D), 1.0, 1e-9);
  EXPECT_NEAR(*reference.meanStressEffectivity, 1.0, 1e-9);
  EXPECT_GT(*reference.effectivity, 1.0);
  EXPECT_LT(*reference.effectivity, 1.5);
}

/// With contact everywhere the contact term is what is missing: half of D^2 / 2 + the term is what the mean misses.
TEST(Reference, MeanStressErrorIsKnownWhereAllIsInContact)
{
  for (const char* tolerance : {"1e-10", "0.5"}) { // converged, and stopped early
    Scene scene = punch(3);
    scene.set(std::string("Coupling/Stopping/Tolerance=") + tolerance);
    scene.set("Error Estimation/Estimators={Global, Reference}").set("Error Estimation/Reference/Refinements=2");
    const auto errors = scene.run().run.summary.errors.value();
    EXPECT_NEAR(*errors.reference->meanStressEffectivity, 1.0, 1e-8) << tolerance;
    EXPECT_GE(*errors.reference->effectivity, 1.0);
  }
}

TEST(Reference, GoesAsDeepAsTheLimitAllows)
{
  const Scenery scenery(punch(2));
  const auto u = scenery.solve(0).displacement();
  const auto full = scenery.compare(u, {2, 100000});
  EXPECT_EQ(full.refinements, 2);
  EXPECT_EQ(full.dofs, scenery.solve(2).dofs());
  EXPECT_EQ(full.note, "");
  EXPECT_GT(full.relative, 0.03);
  EXPECT_LT(full.relative, 0.3);
  const auto limited = scenery.compare(u, {3, 1000});
  EXPECT_EQ(limited.refinements, 1);
  EXPECT_LE(limited.dofs, 1000);
  EXPECT_EQ(limited.note, "1 of 3 refinements: the next one would have more than 1000 dofs");
  const auto none = scenery.compare(u, {3, 300});
  EXPECT_EQ(none.refinements, 0);
  EXPECT_TRUE(std::isnan(none.displacement));
  EXPECT_NE(none.note, "");
}
