#include "ndframe/scene/vertex_pieces.hpp"

#include <algorithm>

#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/joined_vertices.hpp"

namespace ndframe
{
namespace
{

/// The place of a body among some of the scene's; their number if it is none of them.
std::size_t placeOf(const std::string& name, const std::vector<std::size_t>& bodies, const SceneSettings& scene)
{
  return std::size_t(
      std::find_if(bodies.begin(), bodies.end(), [&](std::size_t body) { return scene.bodies[body].name == name; }) -
      bodies.begin());
}

/// What of some bodies lies on each other. Sides that do not match, or do not exist, which a run tells, have nothing.
std::vector<TouchingVertices> touching(const std::vector<const Mesh*>& meshes, const std::vector<std::size_t>& bodies,
                                       const SceneSettings& scene)
{
  std::vector<TouchingVertices> all;
  for (const InterfaceSettings& interface : scene.interfaces) {
    const std::size_t a = placeOf(interface.dirichletBody, bodies, scene),
                      b = placeOf(interface.neumannBody, bodies, scene);
    if (a == bodies.size() || b == bodies.size())
      continue;
    const Mesh &first = *meshes[bodies[a]], &second = *meshes[bodies[b]];
    const Side *ours = first.findSide(interface.dirichletSide),
               *theirs = second.findSide(interface.neumannSide.value_or(interface.name));
    if (ours != nullptr && theirs != nullptr)
      all.push_back({a, b, commonVertices(first, *ours, second, *theirs)});
  }
  return all;
}

} // namespace

std::vector<std::vector<int>> piecesOfVertices(const std::vector<const Mesh*>& meshes, const SceneSettings& scene,
                                               int pieces)
{
  std::vector<std::vector<int>> all(meshes.size());
  for (const int dim : {2, 3}) {
    std::vector<std::size_t> bodies;
    std::vector<int> numVertices;
    std::vector<const Mesh*> ofBodies;
    std::vector<RefinedNumbers> numbers;
    for (std::size_t b = 0; b < meshes.size(); ++b)
      if (meshes[b] != nullptr && meshes[b]->dim == dim) {
        bodies.push_back(b);
        numVertices.push_back(meshes[b]->numPoints());
        ofBodies.push_back(meshes[b]);
        numbers.emplace_back(*meshes[b], halvingsOf(scene.bodies[b].shape));
      }
    if (bodies.empty())
      continue;
    std::vector<const RefinedNumbers*> pointers;
    for (const RefinedNumbers& ofBody : numbers)
      pointers.push_back(&ofBody);
    const JoinedVertices joined = joinedVertices(numVertices, touching(meshes, bodies, scene));
    std::vector<std::vector<int>> found = partitionJoined(joined, ofBodies, pointers, pieces);
    for (std::size_t b = 0; b < bodies.size(); ++b)
      all[bodies[b]] = std::move(found[b]);
  }
  return all;
}

} // namespace ndframe
