#include "sample_contact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "admissibility/turn_facets.hpp"
#include "common/test_main.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe::test
{

namespace
{

BodyModel contactBody(const ContactKind& kind, bool punch)
{
  Mesh mesh = shaken(box({3, 2}, "Right", 0.0, {1.0, 0.7}), 0.04, punch ? 3u : 5u);
  mesh = moved(mesh, [&](double* point) {
    point[1] += (punch ? 0.0 : -0.7) + (kind.kinked ? 0.3 * std::abs(point[0] - 2.0 / 3) : 0.0);
    point[0] *= kind.length, point[1] *= kind.length;
  });
  if (kind.renumbered)
    mesh = renumbered(mesh, punch ? 11 : 12);
  Conditions conditions;
  if (punch)
    conditions.loads = {{"Pressure", {{"Side", "top"}, {"Value", fmt::format("{:.17g}", kind.stress)}}}};
  if (punch && !kind.floating)
    conditions.supports = {onSide("Roller", "left")};
  if (!punch)
    conditions.supports = {onSide("Clamp", "bottom")};
  BodyModel body = makeBody(std::move(mesh), kind.order, conditions);
  body.laws = isotropic((punch ? 3.0 : 1.0) * kind.stress, 0.3);
  return body;
}

std::array<double, 2> middle(const Mesh& mesh, Facet facet)
{
  int v[2];
  facetVertices(mesh, facet, v);
  return {0.5 * (mesh.point(v[0])[0] + mesh.point(v[1])[0]), 0.5 * (mesh.point(v[0])[1] + mesh.point(v[1])[1])};
}

std::array<int, 3> ascendingNodes(const BodyModel& body, Facet facet)
{
  std::array<int, 3> nodes{};
  facetNodes(body.nodes, facet, nodes.data());
  if (nodes[0] > nodes[1])
    std::swap(nodes[0], nodes[1]);
  return nodes;
}

/// Pairs the punch's bottom with the foundation's top; interface nodes are numbered as they come.
void addFacets(ContactScene& scene)
{
  const BodyModel &punch = scene.bodies[0], &foundation = scene.bodies[1];
  std::map<int, int> number;
  for (const Facet& facet : punch.side("bottom")->facets) {
    const auto at = middle(punch.mesh, facet);
    const auto& tops = foundation.side("top")->facets;
    const auto other = *std::min_element(tops.begin(), tops.end(), [&](Facet a, Facet b) {
      return std::abs(middle(foundation.mesh, a)[0] - at[0]) < std::abs(middle(foundation.mesh, b)[0] - at[0]);
    });
    ContactPatch contact;
    contact.sides = {{{0, facet}, {1, other}}};
    contact.measure = facetNormal(punch.mesh, facet, contact.normal.data());
    const auto ours = ascendingNodes(punch, facet), theirs = ascendingNodes(foundation, other);
    if ((punch.nodes.point(ours[0])[0] < at[0]) != (foundation.nodes.point(theirs[0])[0] < at[0]))
      contact.sides[1].places = {1, 0, 2};
    for (std::size_t i = 0; i < std::size_t(punch.nodes.nodesPerFacet); ++i) {
      const auto [found, isNew] = number.emplace(ours[i], int(scene.x.size()));
      if (isNew)
        scene.x.push_back(punch.nodes.point(ours[i])[0]);
      contact.nodes[i] = found->second;
    }
    contact.pairs = contact.nodes;
    scene.recovery.patches.push_back(contact);
  }
}

/// The rigid motions that the punch is free to make.
DenseMatrix freeMotions(const BodyModel& punch)
{
  const RigidBasis basis = rigidBasis(punch.mesh);
  return nullSpace(supportRows(basis, punch.nodes, constraintsOf(punch)), rigidTolerance);
}

BalanceConditions balanceOf(const ContactScene& scene, const BodySystem& system)
{
  const BodyModel& punch = scene.bodies[0];
  const DenseMatrix motions = freeMotions(punch),
                    modes = multiply(rigidModes(rigidBasis(punch.mesh), punch.nodes, system.dofs.frames), motions);
  const auto numNodes = scene.x.size();
  BalanceConditions balance{SparseColumns(int(numNodes), motions.cols()), {}, {}, {}};
  for (std::size_t node = 0; node < numNodes; ++node) {
    Vector unit(numNodes, 0.0);
    unit[node] = 1.0;
    const auto traction = tractionFromNodes(scene.recovery.patches, unit, punch.nodes.order, punch.nodes.order);
    const Vector force = contactForces(punch, 0, scene.recovery.patches, {traction, traction});
    for (int m = 0; m < motions.cols(); ++m)
      balance.work(int(node), m) = dot(system.dofs.frames.toLocal(force), modes.column(m));
  }
  for (int m = 0; m < motions.cols(); ++m) {
    balance.value.push_back(-dot(system.load.all(), modes.column(m)));
    balance.names.push_back(std::to_string(m));
  }
  return balance;
}

/// Holds what is free without reactions, because the forces are in balance: u_x, u_y at a node, u_y far from it.
void pin(BodySystem& system, const BodyModel& body, int motions)
{
  const Side& top = *body.side("top");
  const auto nodes = sideNodes(body.nodes, top);
  const auto [left, right] = std::minmax_element(
      nodes.begin(), nodes.end(), [&](int a, int b) { return body.nodes.point(a)[0] < body.nodes.point(b)[0]; });
  const int dofs[] = {2 * *right + 1, 2 * *right, 2 * *left + 1};
  for (int m = 0; m < motions; ++m)
    system.dofs.roles[std::size_t(dofs[m])] = DofRole::Fixed;
}

} // namespace

ContactScene contactScene(const ContactKind& kind)
{
  ContactScene scene;
  scene.bodies.push_back(contactBody(kind, true));
  scene.bodies.push_back(contactBody(kind, false));
  addFacets(scene);
  if (kind.turns)
    turnFacets(scene.recovery.patches);
  const auto& patches = scene.recovery.patches;
  std::vector<BodySystem> systems;
  for (const BodyModel& body : scene.bodies)
    systems.push_back(assemble(body, comm()));
  scene.balance = balanceOf(scene, systems[0]);
  Vector mean;
  for (const double x : scene.x)
    mean.push_back(kind.stress * (kind.pull * x / kind.length - 1.0));
  const Vector nodal = projectTraction(patches, int(scene.x.size()), kind.order, mean, scene.balance);
  scene.field.tractions.fill(tractionFromNodes(patches, nodal, kind.order, kind.degree));
  scene.field.optimise = true;
  pin(systems[0], scene.bodies[0], scene.balance.work.cols());
  for (std::size_t b = 0; b < 2; ++b) {
    NodalField force =
        systems[b].dofs.frames.toLocal(contactForces(scene.bodies[b], int(b), patches, scene.field.tractions));
    const NodalField load = systems[b].load.all();
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] += load[i];
    systems[b].load = SparseField(force);
    scene.displacement.push_back(solve(systems[b], comm()));
    std::vector<Facet> own;
    for (const ContactPatch& patch : patches)
      own.push_back(patch.sides[b].facet);
    scene.recovery.data.push_back(makeStaticData(scene.bodies[b], kind.degree, own));
    scene.recovery.bodies.push_back(&scene.bodies[b]);
  }
  for (const NodalField& displacement : scene.displacement)
    scene.field.displacement.push_back(&displacement.whole());
  Vector gap;
  for (const double x : scene.x)
    gap.push_back(0.1 * x * x / kind.length);
  scene.field.opening = jumpMoments(scene.recovery.bodies, patches, scene.displacement, kind.degree);
  const Vector gapMoments = nodalMoments(patches, gap, kind.order, kind.degree);
  for (std::size_t i = 0; i < gapMoments.size(); ++i)
    scene.field.opening[i] -= gapMoments[i];
  return scene;
}

std::vector<Vector> sharesOf(const ContactScene& scene, const ContactTraction& traction)
{
  return {contactShares(scene.recovery.patches, {traction, traction}, 0),
          contactShares(scene.recovery.patches, {traction, traction}, 1)};
}

double objective(const ContactScene& scene, const ContactTraction& traction,
                 const std::vector<StressCorrection>& corrections)
{
  const Vector contact = contactContributions(scene.recovery.patches, traction, scene.field.opening);
  return energyOf(scene.bodies[0], corrections[0]) + energyOf(scene.bodies[1], corrections[1]) +
         std::accumulate(contact.begin(), contact.end(), 0.0);
}

} // namespace ndframe::test
