// Solids in contact: the traction between them changes together with the stresses, and stays admissible.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/admissibility/admissible_traction.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "recovery/sample_recovery.hpp"
#include "stress_descent.hpp"

namespace ndframe
{

namespace
{

/// What a scene is made like.
struct PairKind
{
  int order = 2, degree = 2;
  double rotation = 0.0;  ///< degrees about z
  double pull = 0.0;      ///< the traction that is projected is -1 + pull x
  unsigned numbering = 0; ///< of points and cells
  double length = 1.0, stress = 1.0;
  double apart = 0.0; ///< the lower body is drawn lower by this
};

std::string nameOf(const testing::TestParamInfo<PairKind>& test)
{
  const PairKind& kind = test.param;
  return fmt::format("Order{}Degree{}{}{}{}", kind.order, kind.degree, kind.rotation != 0.0 ? "Turned" : "",
                     kind.pull > 0.0 ? "Lifted" : "", kind.apart > 0.0 ? "Apart" : "");
}

/// A block (body 0, Dirichlet), held at its left, on a longer one that is clamped below (body 1, Neumann).
class SolidPair
{
public:
  explicit SolidPair(const PairKind& kind) : kind_(kind)
  {
    bodies.push_back(body(true));
    bodies.push_back(body(false));
    addFacets();
    Vector mean;
    for (const double x : x_)
      mean.push_back(kind.stress * (kind.pull * x / kind.length - 1.0));
    const BalanceConditions none{SparseColumns(int(x_.size()), 0), {}, {}, {}};
    const Vector nodal = projectTraction(recovery.patches, int(x_.size()), kind.order, mean, none);
    field.tractions.fill(tractionFromNodes(recovery.patches, nodal, kind.order, kind.degree));
    field.optimise = true;
    solve();
  }

  std::vector<BodyModel> bodies;
  RecoveryScene recovery;
  SceneField field;

  SceneStress recovered(int steps) const
  {
    Ledger ledger;
    return test::recoverWhole(*test::withSteps(kind_.degree, steps), recovery, {field}, ledger)[0];
  }

  /// As many as lower the bound.
  std::int64_t stepsTaken() const
  {
    Ledger ledger;
    test::recoverWhole(*test::makeRecovery("Global", {{"Degree", kind_.degree}}), recovery, {field}, ledger);
    return ledger.counted("recovery steps");
  }

  /// What a descent from stresses that are only in balance says that the objective is, and the objective: before the
  /// first step and after some.
  std::vector<std::pair<double, double>> told(int steps) const
  {
    const StarBody above(bodies[0], recovery.data[0]), below(bodies[1], recovery.data[1]);
    const StressCells cells({&above, &below});
    const StressFaces faces(cells, recovery.patches);
    SceneStress stress = recovered(0);
    const DescentField changes{{&stress.corrections[0], &stress.corrections[1]}, &stress.tractions[0], &field.opening};
    const DescentWatch watch{[] {}, [](double) {}};
    StressDescent descent(faces, recovery.patches, {changes}, watch, Comm::single(), 1);
    std::vector<std::pair<double, double>> result{{descent.energy(0), objective(stress)}};
    EXPECT_EQ(descent.lower({steps, 0.0}), steps);
    result.emplace_back(descent.energy(0), objective(stress));
    return result;
  }

  /// |c|^2 + 2 int t (u~1_N - u~2_N - g)
  double objective(const SceneStress& stress) const
  {
    const Vector contact = contactContributions(recovery.patches, stress.tractions[0], field.opening);
    return std::accumulate(contact.begin(), contact.end(), energyOf(stress));
  }

  double energyOf(const SceneStress& stress) const
  {
    return test::energyOf(bodies[0], stress.corrections[0]) + test::energyOf(bodies[1], stress.corrections[1]);
  }

  double defect(const SceneStress& stress) const
  {
    double largest = 0.0;
    for (std::size_t b = 0; b < 2; ++b) {
      const Vector shares = contactShares(recovery.patches, stress.tractions, int(b));
      const FieldInput input{field.displacement[b], &shares};
      largest =
          std::max(largest, checkEquilibrium(bodies[b], recovery.data[b], input, stress.corrections[b]).largest());
    }
    return largest;
  }

  /// Largest coefficient of the traction relative to the largest that presses.
  double tension(const ContactTraction& traction) const
  {
    ContactTraction opposite = traction;
    for (double& share : opposite.shares)
      share = -share;
    return largestBernstein(traction, recovery.patches) / largestBernstein(opposite, recovery.patches);
  }

private:
  BodyModel body(bool upper) const
  {
    Mesh mesh = upper ? test::box({3, 2, 1}, "Right", 0.0, {1.0, 0.8, 0.5})
                      : test::box({6, 2, 2}, "Right", 0.0, {2.0, 0.8, 0.6});
    if (kind_.numbering > 0)
      mesh = test::renumbered(mesh, kind_.numbering + (upper ? 0 : 1));
    const double angle = kind_.rotation * std::acos(-1.0) / 180.0, c = std::cos(angle), s = std::sin(angle);
    mesh = test::moved(mesh, [&](double* x) {
      x[2] -= upper ? 0.0 : 0.6 + kind_.apart;
      const double a = x[0], b = x[2]; // about y: the interface is inclined
      x[0] = kind_.length * (c * a - s * b), x[1] *= kind_.length, x[2] = kind_.length * (s * a + c * b);
    });
    test::Conditions conditions;
    conditions.supports = {test::onSide("Clamp", upper ? "left" : "bottom")};
    BodyModel result = test::makeBody(std::move(mesh), kind_.order, conditions);
    result.laws = test::isotropic((upper ? 4.0 : 1.0) * kind_.stress, 0.3, "Three Dimensional");
    return result;
  }

  static std::vector<int> sortedNodes(const BodyModel& body, Facet facet)
  {
    std::array<int, mostFacetNodes> nodes{};
    facetNodes(body.nodes, facet, nodes.data());
    std::vector<int> vertices(nodes.begin(), nodes.begin() + 3);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  /// The place among the upper block's vertices of the one nearest to a point.
  int nearest(const std::vector<int>& vertices, const double* x) const
  {
    const auto distance = [&](int v) {
      const double* y = bodies[0].mesh.point(v);
      return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
    };
    return int(
        std::min_element(vertices.begin(), vertices.end(), [&](int a, int b) { return distance(a) < distance(b); }) -
        vertices.begin());
  }

  void addFacets()
  {
    std::map<int, int> number;
    for (const Facet mine : bodies[0].side("bottom")->facets)
      for (const Facet other : bodies[1].side("top")->facets) {
        const auto ours = sortedNodes(bodies[0], mine), theirs = sortedNodes(bodies[1], other);
        const auto a = facetCentre(bodies[0].mesh, mine), b = facetCentre(bodies[1].mesh, other);
        if (std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > (kind_.apart + 0.01) * kind_.length)
          continue;
        ContactPatch patch;
        patch.dim = 3;
        patch.sides = {{{0, mine}, {1, other}}};
        patch.measure = facetNormal(bodies[0].mesh, mine, patch.normal.data());
        for (std::size_t k = 0; k < 3; ++k)
          patch.sides[1].places[k] = nearest(ours, bodies[1].mesh.point(theirs[k]));
        const FacetNodes nodes = contactNodes(bodies[0], patch.sides[0]);
        for (std::size_t i = 0; i < std::size_t(bodies[0].nodes.nodesPerFacet); ++i) {
          const auto [found, isNew] = number.emplace(nodes[i], int(x_.size()));
          if (isNew)
            x_.push_back(bodies[0].nodes.point(nodes[i])[0]);
          patch.nodes[i] = found->second;
        }
        patch.pairs = patch.nodes;
        recovery.patches.push_back(patch);
      }
    ASSERT_EQ(recovery.patches.size(), 12u);
  }

  void solve()
  {
    for (std::size_t b = 0; b < 2; ++b) {
      BodySystem system = test::assemble(bodies[b], test::comm());
      NodalField force =
          system.dofs.frames.toLocal(contactForces(bodies[b], int(b), recovery.patches, field.tractions));
      const NodalField load = system.load.all();
      for (std::size_t i = 0; i < force.size(); ++i)
        force[i] += load[i];
      system.load = SparseField(force);
      displacement_.push_back(test::solve(system, test::comm()));
      std::vector<Facet> own;
      for (const ContactPatch& patch : recovery.patches)
        own.push_back(patch.sides[b].facet);
      recovery.data.push_back(makeStaticData(bodies[b], kind_.degree, own));
      recovery.bodies.push_back(&bodies[b]);
    }
    for (const NodalField& displacement : displacement_)
      field.displacement.push_back(&displacement.whole());
    field.opening = jumpMoments(recovery.bodies, recovery.patches, displacement_, kind_.degree);
  }

  PairKind kind_;
  std::vector<double> x_; ///< per interface node
  std::vector<NodalField> displacement_;
};

std::vector<PairKind> kinds()
{
  std::vector<PairKind> all;
  for (const auto& [order, degree] : {std::pair(1, 1), {1, 2}, {2, 2}}) {
    PairKind kind;
    kind.order = order, kind.degree = degree, kind.numbering = 3;
    all.push_back(kind);
    kind.rotation = 25.0, kind.pull = 2.0;
    all.push_back(kind);
    kind.apart = 0.05, kind.pull = 0.5;
    all.push_back(kind);
  }
  return all;
}

} // namespace

struct TractionDescent : testing::TestWithParam<PairKind>
{};
INSTANTIATE_TEST_SUITE_P(AllKinds, TractionDescent, testing::ValuesIn(kinds()), nameOf);

TEST_P(TractionDescent, StaysAdmissibleAndInEquilibriumWithBothStresses)
{
  const SolidPair scene(GetParam());
  for (const int steps : {0, 1, 10, 40}) {
    const SceneStress stress = scene.recovered(steps);
    EXPECT_LT(scene.defect(stress), 1e-12) << steps;
    EXPECT_LT(scene.tension(stress.tractions[0]), 1e-13) << steps;
    EXPECT_EQ(stress.tractions[0].shares, stress.tractions[1].shares) << steps;
  }
}

TEST_P(TractionDescent, TellsTheObjectiveThatItLeaves)
{
  for (const auto& [told, measured] : SolidPair(GetParam()).told(30))
    EXPECT_NEAR(told, measured, 1e-5 * std::abs(measured));
}

TEST_P(TractionDescent, MakesTheBoundSmallerThanTheProjectedOneWithEveryStep)
{
  SolidPair scene(GetParam());
  double last = scene.objective(scene.recovered(2));
  for (const int steps : {5, 10, 20, 40, 80}) { // first order is slow with the traction free: it is behind until 40
    const double next = scene.objective(scene.recovered(steps));
    EXPECT_LT(next, last * (1.0 + 1e-6)) << steps;
    last = next;
  }
  scene.field.optimise = false;
  const SceneStress projected = scene.recovered(80);
  EXPECT_EQ(projected.tractions[0].shares, scene.field.tractions[0].shares);
  EXPECT_LT(last, scene.objective(projected));
}

TEST_P(TractionDescent, DependsNeitherOnNumberingNorOnUnits)
{
  PairKind kind = GetParam();
  const SolidPair scene(kind);
  kind.numbering = 11, kind.length = 1e-3, kind.stress = 2e11;
  const SolidPair other(kind);
  // forces by length^2 stress, displacements by length: the objective by length^3 stress
  const double one = scene.objective(scene.recovered(10)),
               two = other.objective(other.recovered(10)) / (std::pow(kind.length, 3) * kind.stress);
  EXPECT_NEAR(two, one, 1e-4 * std::abs(one));
  EXPECT_EQ(other.stepsTaken(), scene.stepsTaken());
}

} // namespace ndframe
