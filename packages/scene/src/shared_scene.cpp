#include "ndframe/scene/shared_scene.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/base/grouped.hpp"
#include "ndframe/scene/joined_vertices.hpp"

namespace ndframe
{
namespace
{

/// The bodies that are not rigid.
std::vector<int> drawnBodies(const SceneSettings& scene)
{
  std::vector<int> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].isRigid)
      bodies.push_back(int(b));
  return bodies;
}

/// Who owns the drawn vertices of the bodies that are not rigid.
std::vector<DrawnOwners> shareOut(const DrawnScene& scene, const std::vector<int>& bodies, int ranks)
{
  const Model& drawn = *scene.model;
  const JoinedVertices joined = joinedVertices(drawn, bodies);
  std::vector<const Mesh*> meshes;
  std::vector<const RefinedNumbers*> numbers;
  for (const int body : bodies) {
    meshes.push_back(&drawn.bodies[std::size_t(body)].mesh);
    numbers.push_back(&scene.numbers[std::size_t(body)]);
  }
  std::vector<std::vector<int>> rankOf = partitionJoined(joined, meshes, numbers, ranks);
  std::vector<DrawnOwners> owners;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    owners.push_back({joined.numbers[b], std::move(rankOf[b])});
  return owners;
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
GivenMesh partOf(const DrawnPart& drawn, const std::vector<std::string>& sides, bool withHalo, const Comm& comm)
{
  RefinedShare share =
      refinedShare(drawn.mesh, drawn.halvings, drawn.numbers, drawn.owners, comm.rank(), sides, withHalo);
  NodeMap nodes = makeNodeMap(share.mesh, 2);
  const std::vector<BodyShare::Global> middles = sortEdges(nodes, share, drawn.numbers);
  std::vector<int> ranks;
  for (int node = 0; node < nodes.numNodes(); ++node) {
    const auto [a, b] = nodes.ends(node);
    ranks.push_back(
        drawn.owners.rankOf(DrawnPlace::middle(share.points[std::size_t(a)], share.points[std::size_t(b)])));
  }
  share.numbers.insert(share.numbers.end(), middles.begin(), middles.end());
  BodyShare::Things ofNodes{drawn.numbers.numPoints() + drawn.numbers.numMiddles(), std::move(share.numbers),
                            std::move(ranks)},
      ofCells{drawn.numbers.numCells(), std::move(share.cellNumbers), std::move(share.cellOwners)};
  GivenMesh part(std::move(share.mesh), std::move(nodes));
  part.share = std::make_shared<const BodyShare>(std::move(ofNodes), std::move(ofCells), comm);
  return part;
}

/// What a user should know of how the cells are shared out. halvings: of the mesh as it was read.
std::string noteOf(const BodyShare& share, int dim, int halvings, bool isRead, const Comm& comm)
{
  const Vector cells = gatheredFrom({double(share.numOwnCells())}, comm);
  const auto [least, most] = std::minmax_element(cells.begin(), cells.end());
  const std::string shares = fmt::format("the {} processes in shares of {} to {}.", comm.size(),
                                         grouped(std::int64_t(*least)), grouped(std::int64_t(*most)));
  if (halvings == 0)
    return fmt::format("{} cells, {} {}", grouped(share.numCells()), isRead ? "read in pieces by" : "shared out among",
                       shares);
  return fmt::format("Refine = {}: {} cells{} became {}, made by {}", halvings,
                     grouped(share.numCells() >> (dim * halvings)), isRead ? ", read in pieces," : "",
                     grouped(share.numCells()), shares);
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

/// Makes a body that was built on a rank's part of its mesh a share of the whole one.
void completePart(Model& model, std::size_t b, const Comm& comm)
{
  BodyModel& body = model.bodies[b];
  const BodyShare* const share = body.share.get();
  fetchConstraints(*share, model.constraints[b]);
  const NodalField all = model.loads[b].all();
  Vector load = all.whole(); // complete at own nodes only
  share->annulOthers(load, body.mesh.dim);
  model.loads[b] = SparseField(atNodes(std::move(load), body.mesh.dim));
  body.mesh.notes.push_back(noteOf(*share, body.mesh.dim, model.told->halvings[b], model.told->areRead, comm));
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

std::vector<DrawnPart> drawnParts(DrawnScene&& given, const SceneSettings& scene, bool withHalo, const Comm& comm)
{
  const DrawnScene drawn = std::move(given); // given back at the end
  const std::vector<int> bodies = drawnBodies(scene);
  std::vector<DrawnOwners> owners(bodies.size());
  if (comm.rank() == 0)
    owners = shareOut(drawn, bodies, comm.size());
  std::vector<DrawnPart> parts;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto body = std::size_t(bodies[b]);
    std::optional<DrawnParts> all;
    if (comm.rank() == 0)
      all.emplace(drawn.model->bodies[body].mesh, drawn.halvings[body], drawn.numbers[body], owners[b],
                  contactSides(scene, scene.bodies[body].name), comm.size(), withHalo);
    parts.push_back(drawnPartFromBytes(handedOut(comm, [&](int rank) { return all->bytesOf(rank); })));
  }
  return parts;
}

Model sharedModel(std::vector<DrawnPart> drawn, ToldScene told, const SceneSettings& scene,
                  const SceneComponents& components, const std::vector<InterfaceMesh>& earlier, bool withHalo,
                  const Comm& comm, int threads)
{
  const std::vector<int> bodies = drawnBodies(scene);
  std::vector<GivenMesh> parts(scene.bodies.size(), Mesh());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto body = std::size_t(bodies[b]);
    parts[body] = partOf(drawn[b], contactSides(scene, scene.bodies[body].name), withHalo, comm);
  }
  drawn = {}; // its memory is needed again
  Model model;
  onEveryRank(comm, [&] { // a mistake may show in one rank's share only
    std::size_t next = 0;
    model = buildModel(
        scene, components, [&](const BodySettings&) { return std::move(parts[next++]); }, earlier, threads,
        std::make_shared<const ToldScene>(std::move(told)));
  });
  for (const int body : bodies)
    completePart(model, std::size_t(body), comm);
  compareInterfaces(model, comm);
  model.solvesWhole = true;
  return model;
}

} // namespace ndframe
