#include "ndframe/condensation/reactions.hpp"

#include <algorithm>
#include <map>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{
namespace
{

/// A direction that a support prescribes at a node.
struct Hold
{
  std::size_t support;
  Direction direction;
};

std::map<int, std::vector<Hold>> holdsOf(const BodyModel& body)
{
  std::map<int, std::vector<Hold>> holds;
  for (std::size_t s = 0; s < body.supports.size(); ++s)
    for (const auto& constraint : body.supports[s]->constraints(body.mesh, body.nodes))
      holds[constraint.node].push_back({s, constraint.direction});
  return holds;
}

/// The smallest multiples of the directions that add up to the force, which lies in their span.
Vector sharesOf(const Vector& force, const std::vector<Hold>& holds)
{
  constexpr double parallel = 1e-9;
  DenseMatrix directions(int(force.size()), int(holds.size()));
  for (int h = 0; h < directions.cols(); ++h)
    std::copy_n(holds[std::size_t(h)].direction.begin(), force.size(), directions.col(h));
  return multiply(pseudoInverse(directions, parallel), force);
}

/// Mean of the nodes at which a point or a mean motion is held.
Direction centreOfNodes(const Support& support, const BodyModel& body, const Comm& comm)
{
  Vector sums(4, 0.0); // of the coordinates, and how many
  for (const auto& constraint : support.constraints(body.mesh, body.nodes)) {
    if (body.share && !body.share->owns(constraint.node))
      continue;
    for (int k = 0; k < body.mesh.dim; ++k)
      sums[std::size_t(k)] += body.nodes.point(constraint.node)[k];
    ++sums[3];
  }
  if (body.share)
    comm.sum(sums);
  return {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
}

/// Centre of a support's side.
Direction centreOf(const Support& support, const BodyModel& body, const Comm& comm)
{
  if (support.holdsMeanMotion() || support.holdsPoint()) // the mean over a side is held elsewhere
    return centreOfNodes(support, body, comm);
  Direction normal{};
  Vector sums(4, 0.0); // first moments, and the measure
  int vertices[3];
  for (const Facet facet : support.facets(body.mesh)) {
    if (body.share && facet.cell >= body.share->numOwnCells())
      continue;
    const double measure = facetNormal(body.mesh, facet, normal.data());
    facetVertices(body.mesh, facet, vertices);
    sums[3] += measure;
    for (int v = 0; v < body.mesh.dim; ++v)
      for (int k = 0; k < body.mesh.dim; ++k)
        sums[std::size_t(k)] += measure / body.mesh.dim * body.mesh.point(vertices[v])[k];
  }
  if (body.share)
    comm.sum(sums);
  return {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
}

} // namespace

NodalField contactForces(const Model& model, const CondensedModel& condensed, const InterfaceState& state, int body)
{
  const BodyModel& on = model.bodies[std::size_t(body)];
  Vector forces(std::size_t(on.numDofs()), 0.0);
  const InterfaceValues dirichlet = condensed.interface.nodalForces(state.forceDirichlet);
  InterfaceValues neumann = condensed.interface.nodalForces(state.forceNeumann);
  for (double& force : neumann)
    force = -force;
  std::size_t first = 0;
  const auto add = [&](const InterfaceMesh& interface, const std::vector<int>& nodes, const Vector& along) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t k = 0; k < std::size_t(interface.dim); ++k)
        forces[std::size_t(nodes[i]) * std::size_t(interface.dim) + k] += along[first + i] * interface.normals[i][k];
  };
  for (const auto& interface : model.interfaces) {
    if (interface.dirichlet().body == body)
      add(interface, interface.dirichlet().nodes, dirichlet);
    if (interface.neumann().body == body)
      add(interface, interface.neumann().nodes, neumann);
    first += std::size_t(interface.numNodes());
  }
  return atNodes(std::move(forces), on.mesh.dim);
}

NodalField supportForces(const Model& model, const CondensedModel& condensed, const InterfaceState& state, int body,
                         const BodyFields& fields)
{
  const BodySystem& system = condensed.systems[std::size_t(body)];
  Vector forces = fields.forces.whole();
  const NodalField inGlobalAxes = contactForces(model, condensed, state, body);
  const NodalField contact = system.dofs.frames.toLocal(inGlobalAxes);
  system.load.addTo(forces, -1.0);
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = system.dofs.roles[i] == DofRole::Fixed ? forces[i] - contact[i] : 0.0;
  if (system.share)
    system.share->annulOthers(forces, system.K.dim);
  return system.dofs.frames.toGlobal(forces);
}

std::vector<SupportSummary> supportReactions(const BodyModel& body, const Vector& forces, const Comm& comm)
{
  const int dim = body.mesh.dim;
  std::vector<SupportSummary> reactions;
  std::vector<Direction> centres;
  for (const auto& support : body.supports) {
    centres.push_back(centreOf(*support, body, comm));
    reactions.push_back({support->params().name(), support->description(), Vector(std::size_t(dim), 0.0),
                         Vector(dim == 2 ? 1 : 3, 0.0), Vector(centres.back().begin(), centres.back().begin() + dim)});
  }
  for (const auto& [node, holds] : holdsOf(body)) {
    const double* force = forces.data() + std::ptrdiff_t(node) * dim;
    const Vector shares = sharesOf({force, force + dim}, holds);
    for (std::size_t h = 0; h < holds.size(); ++h) {
      Direction part{}, arm{};
      for (std::size_t k = 0; k < std::size_t(dim); ++k) {
        part[k] = shares[h] * holds[h].direction[k];
        arm[k] = body.nodes.point(node)[k] - centres[holds[h].support][k];
        reactions[holds[h].support].force[k] += part[k];
      }
      const auto moment = momentOf(arm, part, dim);
      for (std::size_t k = 0; k < moment.size(); ++k)
        reactions[holds[h].support].moment[k] += moment[k];
    }
  }
  for (SupportSummary& reaction : reactions)
    if (body.share) {
      comm.sum(reaction.force);
      comm.sum(reaction.moment);
    }
  return reactions;
}

} // namespace ndframe
