#include <cmath>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A box whose left side is moved by 0.1 along x, with traces at its bottom along a normal that is oblique to that
/// direction: at the corner the normal displacement is u_N = a s + b with a != 1, b != 0. Two of its nodes have a
/// second normal, one that is no unit vector.
struct ObliqueBox
{
  explicit ObliqueBox(const std::string& displacement = "0.1")
      : model(boxBody("body", box("0, 0", "2, 1", "3, 2"), 2,
                      list("wall", text("Type", "Displacement") + text("Side", "left") + text("X", displacement)) +
                          list("top", text("Type", "Roller") + text("Side", "top")))),
        traces(bottom()), body(model, traces), load(randomVector(std::size_t(model.numDofs()), 1))
  {
    body.system.load = SparseField(body.system.dofs.frames.toLocal(load));
  }

  std::vector<TraceNormal> bottom() const
  {
    std::vector<TraceNormal> result;
    for (const int node : sideNodes(model.nodes, *model.side("bottom")))
      result.push_back({node, {0.6, -0.8, 0.0}});
    for (const std::size_t twice : {1u, 3u}) {
      result.push_back({result[twice].node, {-0.3, -1.1, 0.0}});
      EXPECT_GT(model.nodes.point(result[twice].node)[0], 0.0);
    }
    return result;
  }
  TraceMap map() const { return TraceMap(body.system.dofs.trace); }
  std::shared_ptr<const SymmetricOperator> schur(const std::string& type) const
  {
    return traceOperator(*body.condensed, map(), *makeInterfaceOperator(type));
  }
  Vector reducedLoad(const SymmetricOperator& S) const
  {
    return traceLoad(*body.condensed, map(), S, body.system.effectiveLoad(comm()).all());
  }
  /// The whole body's displacement under the load, with these normal displacements; global axes.
  Vector displacement(const Vector& normalDisplacement) const
  {
    const Vector kept = map().keptValues(normalDisplacement);
    Vector u =
        body.condensed->expand(DenseMatrix(body.system.effectiveLoad(comm()).all()), DenseMatrix(kept)).column(0);
    body.system.dofs.addPrescribed(u);
    return body.system.dofs.frames.toGlobal(u);
  }
  /// K u - f of the uncondensed body, in global axes.
  Vector reaction(const Vector& u) const
  {
    auto plain = makeDofLayout(model.nodes, ConstraintSet(2, 1.0), {});
    std::vector<int> all;
    for (int i = 0; i < model.nodes.numNodes(); ++i)
      all.push_back(i);
    Vector r = multiply(assembleBody(model, std::move(plain), all).K, u, comm());
    for (std::size_t i = 0; i < r.size(); ++i)
      r[i] -= load[i];
    return r;
  }

  BodyModel model;
  std::vector<TraceNormal> traces;
  CondensedBox body;
  Vector load;
};

} // namespace

TEST(BodyTrace, CornerOfAnObliqueNormalIsScaledAndMoved)
{
  const ObliqueBox box;
  int scaled = 0;
  for (const auto& t : box.body.system.dofs.trace)
    if (t.others.empty() && std::abs(std::abs(t.scale) - 1.0) > 1e-12) {
      ++scaled;
      EXPECT_NEAR(std::abs(t.scale), 0.8, 1e-14);
      EXPECT_NEAR(t.offset, 0.06, 1e-15);
    }
  EXPECT_EQ(scaled, 1);
}

TEST(BodyTrace, NormalDisplacementsAreThoseThatWereAskedFor)
{
  const ObliqueBox box;
  const Vector normal = randomVector(box.traces.size(), 2), u = box.displacement(normal);
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const auto node = std::size_t(box.traces[i].node);
    const Direction& n = box.traces[i].normal;
    EXPECT_NEAR(n[0] * u[2 * node] + n[1] * u[2 * node + 1], normal[i], 1e-14);
  }
  for (const int node : sideNodes(box.model.nodes, *box.model.side("left")))
    EXPECT_NEAR(u[2 * std::size_t(node)], 0.1, 1e-15);
}

TEST(BodyTrace, CondensedEquationIsThatOfTheUncondensedBody)
{
  // S u_N = g + r, with r n the forces that the uncondensed body needs at the interface and no force anywhere else.
  const ObliqueBox box;
  for (const char* type : {"Condensed", "Matrix Free"}) {
    const auto S = box.schur(type);
    const Vector normal = randomVector(box.traces.size(), 2), Su = S->apply(normal), g = box.reducedLoad(*S);
    Vector reaction = box.reaction(box.displacement(normal));
    for (std::size_t i = 0; i < normal.size(); ++i) {
      const auto node = std::size_t(box.traces[i].node);
      const double r = Su[i] - g[i];
      for (std::size_t k = 0; k < 2; ++k)
        reaction[2 * node + k] -= box.traces[i].normal[k] * r;
    }
    for (int node = 0; node < box.model.nodes.numNodes(); ++node) {
      const auto x = box.model.nodes.point(node);
      const auto dof = std::size_t(2 * node);
      EXPECT_NEAR(x[0] > 0.0 ? reaction[dof] : 0.0, 0.0, 1e-12) << type << " at " << x[0] << ", " << x[1];
      EXPECT_NEAR(x[1] < 1.0 ? reaction[dof + 1] : 0.0, 0.0, 1e-12) << type << " at " << x[0] << ", " << x[1];
    }
  }
}

TEST(BodyTrace, ScaledOperatorIsTheSameStoredAndApplied)
{
  const ObliqueBox box;
  const auto stored = box.schur("Condensed"), applied = box.schur("Matrix Free");
  ASSERT_NE(stored->dense(), nullptr);
  ASSERT_EQ(applied->dense(), nullptr);
  const Vector x = randomVector(box.traces.size(), 3);
  EXPECT_LT(relativeDifference(applied->apply(x), stored->apply(x)), 1e-12);
  const std::vector<char> all(x.size(), 1);
  EXPECT_LT(relativeDifference(applied->inverseOn(all, 0.0)->solve(x), stored->inverseOn(all, 0.0)->solve(x)), 1e-10);
  std::vector<char> some = all; // one of the two normals of a node
  some[1] = some[x.size() - 1] = 0;
  EXPECT_LT(relativeDifference(applied->inverseOn(some, 0.0)->solve(x), stored->inverseOn(some, 0.0)->solve(x)), 1e-10);
}

TEST(BodyTrace, ForcesAndDisplacementsDoTheSameWorkOnBothSidesOfTheTransformation)
{
  const ObliqueBox box("0");
  const TraceMap map = box.map();
  const Vector kept = randomVector(std::size_t(map.size()), 5), force = randomVector(std::size_t(map.size()), 6);
  EXPECT_NEAR(dot(map.values(kept), force), dot(kept, map.keptForces(force)), 1e-13);
  EXPECT_LT(relativeDifference(map.forces(map.keptForces(force)), force), 1e-14);
  EXPECT_LT(relativeDifference(map.keptValues(map.values(kept)), kept), 1e-14);
}

TEST(BodyTrace, CoefficientsOfTheNormalDisplacementsAreValuesLikeThem)
{
  const ObliqueBox box("0.1");
  const TraceMap plain = box.map();
  AffineRows coefficients; // twice the value less half of two others, plus 1, where an end has nothing else
  for (int k = 0; k < plain.size(); ++k) {
    const bool isMiddle = k % 3 == 2;
    coefficients.rows.push_back(isMiddle ? SparseRow{{k, 2.0}, {k - 2, -0.5}, {k - 1, -0.5}} : SparseRow{{k, 1.0}});
    coefficients.offset.push_back(isMiddle ? 1.0 : 0.0);
  }
  const TraceMap map(box.body.system.dofs.trace, coefficients);
  const Vector kept = randomVector(std::size_t(map.size()), 7), force = randomVector(std::size_t(map.size()), 8);
  const Vector normal = plain.values(kept), values = map.values(kept);
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NEAR(values[k], k % 3 == 2 ? 2.0 * normal[k] - 0.5 * (normal[k - 2] + normal[k - 1]) + 1.0 : normal[k],
                1e-14);
  EXPECT_LT(relativeDifference(map.keptValues(values), kept), 1e-14);
  EXPECT_LT(relativeDifference(map.forces(map.keptForces(force)), force), 1e-14);
  TraceMap exchanged = map;
  exchanged.exchange();
  EXPECT_LT(relativeDifference(exchanged.keptValues(exchanged.values(kept)), kept), 1e-14);
  EXPECT_FALSE(map.isLike(plain));
}

TEST(BodyTrace, LoadIsReducedByItselfWhereNothingIsMoved)
{
  const ObliqueBox moved("0.1"), still("0");
  const auto S = still.schur("Condensed");
  for (const auto& t : still.body.system.dofs.trace)
    EXPECT_EQ(t.offset, 0.0);
  EXPECT_GT(relativeDifference(moved.reducedLoad(*S), still.reducedLoad(*S)), 1e-3);
}

TEST(MotionTraces, AreTheNormalComponentsOfRigidMotions)
{
  RigidBasis basis;
  basis.dim = 2;
  basis.centre = {1.0, 1.0, 0.0};
  basis.length = 2.0;
  DenseMatrix motions(3, 2); // translation along y; translation along x plus twice the rotation
  motions(1, 0) = 1.0;
  motions(0, 1) = 1.0;
  motions(2, 1) = 2.0;
  const double a[] = {1.0, 1.0}, b[] = {3.0, 0.0};
  const auto traces = motionTraces(basis, motions, {a, b}, {{0.0, -1.0, 0.0}, {0.6, -0.8, 0.0}});
  EXPECT_NEAR(traces(0, 0), -1.0, 1e-15);
  EXPECT_NEAR(traces(1, 0), -0.8, 1e-15);
  EXPECT_NEAR(traces(0, 1), 0.0, 1e-15);
  // The rotation at b: (1, 2) / length = (0.5, 1), twice that and (1, 0): (2, 2) . n = -0.4.
  EXPECT_NEAR(traces(1, 1), -0.4, 1e-15);
}

TEST(InterfaceSystem, TractionAndForceUndoEachOther)
{
  InterfaceSystem system;
  system.C = std::make_shared<ContactMatrix>(std::vector<InterfaceMesh>{straightInterface({0.0, 1.0, 4.0, 4.5}, 2)});
  system.nodeOfUnknown = {1, 2, 4, 6}; // a support prescribes the others
  const UnknownValues force = ofUnknowns(randomVector(4, 1));
  const InterfaceValues traction = system.traction(force);
  ASSERT_EQ(traction.size(), 7u);
  EXPECT_LT(relativeDifference(system.force(traction), force), 1e-14);
  const Vector nodal = system.C->apply(traction);
  for (const std::size_t node : {0, 3, 5})
    EXPECT_NEAR(nodal[node], 0.0, 1e-14);
}
