#pragma once

#include <string>
#include <vector>

#include "ndframe/meshing/remesh.hpp"

namespace ndframe::test
{

/// Bodies with scripts, their first meshes and where they touch.
struct ScriptScene
{
  std::vector<MeshScript> scripts;
  std::vector<Mesh> meshes;
  std::vector<MatchingSides> matching;
};

/// A body of a script: its text or a path, and its region ("" for all).
MeshScript scriptOf(const std::string& path, const std::string& region = {});

ScriptScene sceneOf(std::vector<MeshScript> scripts, std::vector<MatchingSides> matching = {});

/// The meshes with lengths from a function of x and y.
template <class Length>
std::vector<Mesh> remeshed(const ScriptScene& scene, const Length& length)
{
  std::vector<WantedMesh> wanted;
  for (const Mesh& mesh : scene.meshes) {
    wanted.push_back({mesh, {}});
    for (int v = 0; v < mesh.numPoints(); ++v)
      wanted.back().lengths.push_back(length(mesh.point(v)[0], mesh.point(v)[1]));
  }
  return remesh(scene.scripts, scene.matching, wanted);
}

/// Vertices of a side in order of their coordinates.
std::vector<std::vector<double>> sidePoints(const Mesh& mesh, const std::string& side);

} // namespace ndframe::test
