#include "ndframe/scene/shared_scene.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/base/grouped.hpp"
#include "ndframe/mesh/partition.hpp"
#include "ndframe/mesh/refine.hpp"
#include "ndframe/mesh/refined_share.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/joined_vertices.hpp"
#include "ndframe/scene/shared_mesh.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

/// Who owns the drawn vertices of the bodies that are not rigid.
std::vector<DrawnOwners> shareOut(const Model& drawn, const std::vector<int>& bodies,
                                  const std::vector<RefinedNumbers>& numbers, int ranks)
{
  constexpr double most = 1e9; // METIS adds them up in 32 bits
  const JoinedVertices joined = joinedVertices(drawn, bodies);
  std::vector<double> counts(std::size_t(joined.count), 0.0);
  std::vector<int> cells, weights;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    numbers[b].countNodes(joined.numbers[b], counts);
    for (const int point : drawn.bodies[std::size_t(bodies[b])].mesh.cells)
      cells.push_back(joined(b, point));
  }
  const double scale = std::min(1.0, most / std::accumulate(counts.begin(), counts.end(), 0.0));
  for (const double count : counts)
    weights.push_back(std::max(1, int(scale * count)));
  const int perCell = drawn.bodies[std::size_t(bodies.front())].mesh.dim + 1;
  const std::vector<int> rank = partitionNodes(cells, perCell, joined.count, ranks, weights);
  std::vector<DrawnOwners> owners;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    owners.push_back({joined.numbers[b], {}});
    for (const int number : joined.numbers[b])
      owners.back().ranks.push_back(rank[std::size_t(number)]);
  }
  return owners;
}

/// The sides of a body that may touch another one.
std::vector<std::string> contactSides(const SceneSettings& scene, const std::string& body)
{
  std::vector<std::string> sides;
  for (const InterfaceSettings& interface : scene.interfaces) {
    if (interface.dirichletBody == body)
      sides.push_back(interface.dirichletSide);
    if (interface.neumannBody == body)
      sides.push_back(interface.neumannSide.value_or(interface.name));
  }
  return sides;
}

/// The nodes on edges in the order of their numbers, which are returned.
std::vector<BodyShare::Global> sortEdges(NodeMap& nodes, const RefinedShare& share, const RefinedNumbers& numbers)
{
  const int vertices = nodes.numVertices();
  std::vector<BodyShare::Global> middles;
  for (const auto& [a, b] : nodes.edges)
    middles.push_back(numbers.middle(DrawnPlace::middle(share.points[std::size_t(a)], share.points[std::size_t(b)])));
  std::vector<int> order(middles.size()), place(middles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return middles[std::size_t(a)] < middles[std::size_t(b)]; });
  std::vector<std::array<int, 2>> edges;
  for (std::size_t i = 0; i < order.size(); ++i) {
    edges.push_back(nodes.edges[std::size_t(order[i])]);
    place[std::size_t(order[i])] = int(i);
  }
  nodes.edges = std::move(edges);
  for (int& node : nodes.cellNodes)
    if (node >= vertices)
      node = vertices + place[std::size_t(node - vertices)];
  std::sort(middles.begin(), middles.end());
  return middles;
}

/// A body's mesh and nodes on this rank.
struct Part
{
  GivenMesh given = Mesh();
  std::shared_ptr<const BodyShare> share;
};

Part partOf(const Mesh& drawn, int halvings, const RefinedNumbers& numbers, const DrawnOwners& owners,
            const std::vector<std::string>& sides, const Comm& comm)
{
  RefinedShare share = refinedShare(drawn, halvings, numbers, owners, comm.rank(), sides);
  NodeMap nodes = makeNodeMap(share.mesh, 2);
  const std::vector<BodyShare::Global> middles = sortEdges(nodes, share, numbers);
  std::vector<int> ranks;
  for (int node = 0; node < nodes.numNodes(); ++node) {
    const auto [a, b] = nodes.ends(node);
    ranks.push_back(owners.rankOf(DrawnPlace::middle(share.points[std::size_t(a)], share.points[std::size_t(b)])));
  }
  share.numbers.insert(share.numbers.end(), middles.begin(), middles.end());
  Part part;
  part.share = std::make_shared<const BodyShare>(numbers.numPoints() + numbers.numMiddles(), numbers.numCells(),
                                                 std::move(share.numbers), std::move(ranks), share.numOwnCells, comm);
  part.given = GivenMesh(std::move(share.mesh), std::move(nodes));
  return part;
}

/// What a user should know of how the cells are shared out. halvings: of the mesh as it was read.
std::string noteOf(const BodyShare& share, int dim, int halvings, const Comm& comm)
{
  const Vector cells = gatheredFrom({double(share.numOwnCells())}, comm);
  const auto [least, most] = std::minmax_element(cells.begin(), cells.end());
  return fmt::format("Refine = {}: {} cells became {}, made by the {} processes in shares of {} to {}.", halvings,
                     grouped(share.numCells() >> (dim * halvings)), grouped(share.numCells()), comm.size(),
                     grouped(std::int64_t(*least)), grouped(std::int64_t(*most)));
}

/// At nodes of other ranks what these prescribe: they have all facets there.
void fetchConstraints(const BodyShare& share, ConstraintSet& constraints)
{
  constexpr int width = 13; // count, three directions and values
  Vector values(share.numbers().size() * width, 0.0);
  for (const auto& [node, given] : constraints.nodes()) {
    double* next = values.data() + std::ptrdiff_t(node) * width;
    *next++ = given.count;
    for (const Direction& direction : given.direction)
      next = std::copy(direction.begin(), direction.end(), next);
    std::copy(given.value.begin(), given.value.end(), next);
  }
  share.fetch(values, width);
  for (int node = 0; node < int(share.numbers().size()); ++node)
    if (!share.owns(node)) {
      const double* next = values.data() + std::ptrdiff_t(node) * width;
      ConstraintSet::Node given;
      given.count = int(*next++);
      for (Direction& direction : given.direction) {
        std::copy_n(next, direction.size(), direction.begin());
        next += direction.size();
      }
      std::copy_n(next, given.value.size(), given.value.begin());
      constraints.set(node, given);
    }
}

/// Makes a body that was built on a rank's part of its mesh a share of the whole one. halvings: of the mesh as it was
/// read.
void completePart(Model& model, std::size_t b, const std::shared_ptr<const BodyShare>& share, int halvings,
                  const Comm& comm)
{
  BodyModel& body = model.bodies[b];
  body.share = share;
  fetchConstraints(*share, model.constraints[b]);
  Vector load = model.loads[b].all().whole(); // complete at own nodes only
  share->annulOthers(load, body.mesh.dim);
  model.loads[b] = SparseField(atNodes(std::move(load), body.mesh.dim));
  body.mesh.notes.push_back(noteOf(*share, body.mesh.dim, halvings, comm));
}

/// Asserts that all ranks have the same interfaces.
void compareInterfaces(const Model& model, const Comm& comm)
{
  Vector own;
  for (const InterfaceMesh& interface : model.interfaces) {
    double points = 0.0, others = 0.0; // the order counts
    for (std::size_t i = 0; i < interface.points.size(); ++i)
      points += double(i + 1) * interface.points[i];
    for (std::size_t i = 0; i < interface.facets.size(); ++i)
      others += double(i + 1) * interface.facets[i];
    for (std::size_t i = 0; i < interface.normals.size(); ++i)
      others += double(i + 1) * (interface.normals[i][0] + 2.0 * interface.normals[i][1] - interface.normals[i][2]);
    own.insert(own.end(), {double(interface.numNodes()), points, others});
  }
  const Vector all = gatheredFrom(own, comm);
  for (std::size_t i = 0; i < all.size(); ++i)
    NDFRAME_ASSERT(all[i] == own[i % own.size()], "all ranks have the same interfaces");
}

} // namespace

DrawnScene readDrawn(const SceneSettings& scene, const SceneComponents& components, const Comm& comm, Ledger& ledger)
{
  constexpr int verticesOfRank = 200; // METIS shares out fewer unevenly
  const auto timer = timeStage(ledger, Stage::Read);
  DrawnScene drawn;
  ScriptMeshes scripts(ledger);
  std::vector<Mesh> meshes;
  std::int64_t vertices = 0;
  for (const BodySettings& body : scene.bodies) {
    drawn.halvings.push_back(body.isRigid ? 0 : halvingsOf(body.shape));
    meshes.push_back(body.isRigid ? Mesh()
                                  : readShared(components.meshSources.build(body.shape)->drawn(), comm, scripts));
    vertices += meshes.back().numPoints();
  }
  for (bool isRefined = true; isRefined && vertices < std::int64_t(verticesOfRank) * comm.size();) {
    isRefined = false;
    vertices = 0;
    for (std::size_t b = 0; b < meshes.size(); ++b) {
      if (drawn.halvings[b] > 1) {
        meshes[b] = refineUniformly(meshes[b]);
        --drawn.halvings[b];
        isRefined = true;
      }
      vertices += meshes[b].numPoints();
    }
  }
  std::size_t next = 0;
  drawn.model = std::make_shared<Model>(
      buildModel(scene, components, [&](const BodySettings&) { return GivenMesh(std::move(meshes[next++])); }));
  return drawn;
}

std::int64_t refinedDofs(const DrawnScene& drawn, int body)
{
  const Mesh& mesh = drawn.model->bodies[std::size_t(body)].mesh;
  const RefinedNumbers numbers(mesh, drawn.halvings[std::size_t(body)]);
  return mesh.dim * (numbers.numPoints() + numbers.numMiddles());
}

std::string needsWhole(const DrawnScene& drawn)
{
  for (std::size_t b = 0; b < drawn.model->bodies.size(); ++b) {
    const BodyModel& body = drawn.model->bodies[b];
    if (body.isRigid)
      continue;
    if (drawn.halvings[b] == 0)
      return fmt::format("the mesh of \"{}\" is not refined (Refine)", body.name);
    if (!body.regions.empty() || body.mesh.groups.names.size() > 1)
      return fmt::format("\"{}\" has regions or loads in groups of cells", body.name);
    if (!body.parents.empty())
      return fmt::format("the mesh of \"{}\" is cut where sides do not match", body.name);
    for (const auto& support : body.supports)
      if (!support->params().has("Side") || support->holdsMeanMotion())
        return fmt::format("the support \"{}\" of \"{}\" holds no side", support->params().name(), body.name);
  }
  for (const InterfaceMesh& interface : drawn.model->interfaces)
    if (interface.touchesItself())
      return fmt::format("the sides of \"{}\" belong to one body", interface.name);
  return {};
}

Model sharedModel(const DrawnScene& drawn, const SceneSettings& scene, const SceneComponents& components,
                  const Comm& comm, int threads)
{
  const std::vector<int> bodies = drawn.model->elasticBodies();
  std::vector<RefinedNumbers> numbers;
  for (const int body : bodies)
    numbers.emplace_back(drawn.model->bodies[std::size_t(body)].mesh, drawn.halvings[std::size_t(body)]);
  const std::vector<DrawnOwners> owners = shareOut(*drawn.model, bodies, numbers, comm.size());
  std::vector<Part> parts(drawn.model->bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto body = std::size_t(bodies[b]);
    parts[body] = partOf(drawn.model->bodies[body].mesh, drawn.halvings[body], numbers[b], owners[b],
                         contactSides(scene, drawn.model->bodies[body].name), comm);
  }
  Model model;
  onEveryRank(comm, [&] { // a mistake may show in one rank's share only
    std::size_t next = 0;
    model = buildModel(
        scene, components, [&](const BodySettings&) { return std::move(parts[next++].given); }, {}, threads);
  });
  for (std::size_t b = 0; b < parts.size(); ++b)
    if (parts[b].share)
      completePart(model, b, parts[b].share, halvingsOf(scene.bodies[b].shape), comm);
  compareInterfaces(model, comm);
  model.rigid = drawn.model->rigid;
  model.freeMotions = drawn.model->freeMotions;
  model.balancedMotions = drawn.model->balancedMotions;
  model.solvesWhole = drawn.model->solvesWhole;
  model.drawn = drawn.model;
  return model;
}

} // namespace ndframe
