#include "contact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/coupling/relaxation_controller.hpp"

namespace ndframe
{
namespace
{

/// Coordinates of the two sides that differ by more than this, relative to a facet, are not the same line.
constexpr double sameLine = 1e-11;

/// The interface node at a body's node; the facet's nodes are few.
int nodeAt(const InterfaceMesh& interface, int patch, int bodyNode)
{
  const int* nodes = interface.nodesOf(patch);
  const int* found = std::find_if(nodes, nodes + interface.nodesPerFacet(),
                                  [&](int node) { return interface.dirichlet().nodes[std::size_t(node)] == bodyNode; });
  return *found;
}

/// Per interface node the first one with the same nodes of both bodies; a node may face two.
std::vector<int> firstOfPairs(const InterfaceMesh& interface)
{
  std::map<std::pair<int, int>, int> first;
  std::vector<int> pairs;
  for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i)
    pairs.push_back(
        first.emplace(std::pair(interface.dirichlet().nodes[i], interface.neumann().nodes[i]), int(i)).first->second);
  return pairs;
}

ContactPatch makePatch(const Model& model, const InterfaceMesh& interface, int f, const std::vector<int>& pairs,
                       int firstNode)
{
  ContactPatch patch;
  patch.dim = interface.dim;
  for (const std::size_t side : {0u, 1u}) {
    const InterfaceSide& ofInterface = interface.side(bothRoles[side]);
    patch.sides[side].body = ofInterface.body;
    patch.sides[side].facet = ofInterface.facets[std::size_t(f)];
  }
  const BodyModel& body = model.bodies[std::size_t(patch.sides[0].body)];
  patch.measure = interface.measures[std::size_t(f)];
  patch.normal = interface.facetNormals[std::size_t(f)];
  patch.isDrawnApart = !interface.drawnGap.empty();
  const auto nodes = contactNodes(body, patch.sides[0]);
  FacetNodes ours{};
  for (std::size_t i = 0; i < patch.numNodes(interface.order); ++i) {
    ours[i] = nodeAt(interface, f, nodes[i]);
    patch.nodes[i] = firstNode + ours[i];
    patch.pairs[i] = firstNode + pairs[std::size_t(ours[i])];
  }
  std::array<int, 3> theirs{};
  for (std::size_t a = 0; a < patch.numVertices(); ++a) {
    std::copy_n(interface.point(ours[a]), patch.dim, patch.points[a].begin());
    theirs[a] = interface.neumann().nodes[std::size_t(ours[a])];
  }
  patch.sides[1].places = ascendingPlaces(patch.dim, theirs.data());
  const double sign = -sideSign(std::size_t(interface.dirichletSide));
  for (std::size_t i = 0; patch.isDrawnApart && i < patch.numNodes(interface.order); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      patch.drawn[i][k] = sign * interface.apart[std::size_t(ours[i])][k];
  if (!interface.endNormals.empty()) {
    const auto& ends = interface.endNormals[std::size_t(f)];
    const int* order = interface.nodesOf(f);
    patch.turns = dotProduct(ends[0], ends[0]) > 0.0;
    for (std::size_t a = 0; a < patch.numVertices(); ++a)
      patch.ends[a] = ends[std::size_t(std::find(order, order + patch.dim, ours[a]) - order)];
  }
  return patch;
}

} // namespace

std::vector<ContactPatch> contactPatches(const Model& model)
{
  std::vector<ContactPatch> patches;
  int firstNode = 0;
  for (const auto& interface : model.interfaces) {
    const std::vector<int> pairs = firstOfPairs(interface);
    for (int f = 0; f < interface.numFacets(); ++f)
      patches.push_back(makePatch(model, interface, f, pairs, firstNode));
    firstNode += interface.numNodes();
  }
  return patches;
}

std::string geometryCaveat(const Model& model)
{
  for (const auto& interface : model.interfaces) {
    if (interface.map) // which points face each other is a part of the scene, not of the meshes
      continue;
    const BodyModel &first = model.bodies[std::size_t(interface.dirichlet().body)],
                    &second = model.bodies[std::size_t(interface.neumann().body)];
    const double shortest = *std::min_element(interface.measures.begin(), interface.measures.end());
    for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i) {
      const auto x = first.nodes.point(interface.dirichlet().nodes[i]),
                 y = second.nodes.point(interface.neumann().nodes[i]);
      double squared = 0.0, fromOrigin = 0.0;
      for (std::size_t k = 0; k < std::size_t(interface.dim); ++k) {
        squared += (x[k] - y[k]) * (x[k] - y[k]);
        fromOrigin += x[k] * x[k];
      }
      const double apart = std::sqrt(squared);
      if (apart > sameLine * (shortest + std::sqrt(fromOrigin)))
        return fmt::format(
            "the two sides of \"{}\" are {:.1e} apart at {}: give the meshes' coordinates with all digits",
            interface.name, apart, pointText(x.data(), interface.dim));
    }
  }
  return {};
}

BalanceConditions balanceConditions(const Model& model, const CondensedModel& condensed,
                                    const std::vector<ContactPatch>& patches, const Comm& comm)
{
  const int numNodes = condensed.interface.C->size();
  std::vector<SparseRow> rows;
  BalanceConditions conditions;
  for (const auto& trace : condensed.interface.bodies) {
    const auto b = std::size_t(trace.body);
    const DenseMatrix& free = model.balancedMotions[b];
    if (free.cols() == 0)
      continue;
    const BodySystem& system = condensed.systems[b];
    const auto ofBody = patchesOfBody(patches, trace.body);
    const DenseMatrix modes = rigidModes(model.rigid[b], model.bodies[b].nodes, system.dofs.frames);
    const auto names = describeMotions(model.rigid[b], free);
    for (int m = 0; m < free.cols(); ++m) {
      const Vector motion = multiply(modes, free.column(m));
      rows.push_back(motionWork(model.bodies[b], system.dofs.frames.toGlobal(motion), patches, ofBody));
      Vector work{dot(system.load.all(), motion)}; // shares have loads at own nodes
      if (system.share)
        comm.sum(work);
      conditions.value.push_back(-work.front());
      conditions.names.push_back(fmt::format("{} of {}", names[std::size_t(m)], model.bodies[b].name));
    }
  }
  conditions.work = SparseColumns(numNodes, int(rows.size()));
  for (int k = 0; k < conditions.work.cols(); ++k)
    conditions.work.setColumn(k, std::move(rows[std::size_t(k)]));
  return conditions;
}

InterfaceValues meanTraction(const CouplingResult& coupling, bool updated)
{
  const InterfaceValues& dirichlet = coupling.state.tractionDirichlet;
  const InterfaceValues& previous = coupling.state.tractionNeumann;
  const double theta = coupling.history.empty() ? 0.0 : coupling.history.back().theta;
  return relax(dirichlet, updated ? relax(dirichlet, previous, theta) : previous, 0.5);
}

} // namespace ndframe
