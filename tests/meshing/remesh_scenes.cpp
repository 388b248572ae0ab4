#include "remesh_scenes.hpp"

#include <set>

#include "meshing/mesh_deck.hpp"

namespace ndframe::test
{

MeshScript scriptOf(const std::string& path, const std::string& region)
{
  const std::string regions = region.empty() ? "" : strings("Regions", region);
  return meshSource(text("Type", "Gmsh") + text("File", path) + regions)->script();
}

ScriptScene sceneOf(std::vector<MeshScript> scripts, std::vector<MatchingSides> matching)
{
  ScriptScene scene{std::move(scripts), {}, std::move(matching)};
  for (const MeshScript& script : scene.scripts) {
    std::string region;
    for (const std::string& name : script.regions)
      region = strings("Regions", name);
    scene.meshes.push_back(readMesh(text("Type", "Gmsh") + text("File", script.file) + region));
  }
  return scene;
}

std::vector<std::vector<double>> sidePoints(const Mesh& mesh, const std::string& side)
{
  std::set<std::vector<double>> points;
  for (const Facet facet : mesh.findSide(side)->facets) {
    int ends[2];
    facetVertices(mesh, facet, ends);
    for (const int v : ends)
      points.insert({mesh.point(v)[0], mesh.point(v)[1]});
  }
  return {points.begin(), points.end()};
}

} // namespace ndframe::test
