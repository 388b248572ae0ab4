#include "ndframe/meshing/remesh.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "corrected_lengths.hpp"
#include "gmsh_geometry.hpp"
#include "gmsh_library.hpp"
#include "gmsh_solids.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/scratch.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{
namespace
{

/// Lengths grow by no more than this per distance: neighbouring triangles differ by half.
constexpr double slope = 0.5;

/// Two scripts may write the same point with different digits; the first meshes match to 1e-5 of a facet, and new
/// facets are not a hundred times as short at once.
constexpr double samePoint = 1e-3;

/// Vertices of a side, each as often as facets meet there.
std::vector<int> verticesOf(const Mesh& mesh, const std::string& name)
{
  const Side* side = mesh.findSide(name);
  NDFRAME_ASSERT(side, "a mesh made again has the sides of the one before");
  std::vector<int> vertices;
  for (const Facet facet : side->facets) {
    int ends[2];
    facetVertices(mesh, facet, ends);
    vertices.insert(vertices.end(), ends, ends + 2);
  }
  return vertices;
}

/// The lengths of a scene, where bodies match the shorter ones of both.
class SceneLengths
{
public:
  SceneLengths(const std::vector<WantedMesh>& wanted, const std::vector<MatchingSides>& matching)
  {
    for (const WantedMesh& body : wanted) {
      NDFRAME_ASSERT(*std::min_element(body.lengths.begin(), body.lengths.end()) > 0.0, "lengths are positive");
      fields_.emplace_back(body.background, body.lengths);
    }
    if (wanted.front().background.dim == 3) {
      limitGrowth(); // reaches the other body through the vertices that both have
      shareAtVertices();
    } else
      shareOnSides(matching);
    limitGrowth();
  }

  const LengthField& ofBody(std::size_t body) const { return fields_[body]; }

private:
  void limitGrowth()
  {
    for (LengthField& field : fields_)
      field.setLengths(withLimitedGrowth(field.mesh(), field.lengths(), slope));
  }

  void shareAtVertices()
  {
    std::map<std::array<double, 3>, double> shortest;
    const auto forAll = [this](const auto& use) {
      for (LengthField& field : fields_) {
        std::vector<double> lengths = field.lengths();
        for (int v = 0; v < field.mesh().numPoints(); ++v) {
          const double* x = field.mesh().point(v);
          use(std::array<double, 3>{x[0], x[1], x[2]}, lengths[std::size_t(v)]);
        }
        field.setLengths(std::move(lengths));
      }
    };
    forAll([&](const auto& point, double length) {
      double& least = shortest.emplace(point, length).first->second;
      least = std::min(least, length);
    });
    forAll([&](const auto& point, double& length) { length = shortest.at(point); });
  }

  void shareOnSides(const std::vector<MatchingSides>& matching)
  {
    for (const MatchingSides& sides : matching) {
      const std::vector<double> first = shorter(sides.first, sides.firstSide, sides.second);
      fields_[std::size_t(sides.second)].setLengths(shorter(sides.second, sides.secondSide, sides.first));
      fields_[std::size_t(sides.first)].setLengths(first);
    }
  }

  std::vector<double> shorter(int body, const std::string& side, int other) const
  {
    const Mesh& mesh = fields_[std::size_t(body)].mesh();
    std::vector<double> lengths = fields_[std::size_t(body)].lengths();
    for (const int v : verticesOf(mesh, side))
      lengths[std::size_t(v)] =
          std::min(lengths[std::size_t(v)], fields_[std::size_t(other)].at({mesh.point(v)[0], mesh.point(v)[1], 0.0}));
    return lengths;
  }

  std::vector<LengthField> fields_;
};

FixedSide fixedSide(const std::string& name, const Mesh& neighbour, const std::string& neighbourSide)
{
  FixedSide fixed{name, {}, std::numeric_limits<double>::infinity()};
  for (const int v : verticesOf(neighbour, neighbourSide))
    fixed.points.push_back({neighbour.point(v)[0], neighbour.point(v)[1]});
  for (std::size_t i = 0; i < fixed.points.size(); i += 2)
    fixed.tolerance = std::min(fixed.tolerance, samePoint * std::hypot(fixed.points[i + 1][0] - fixed.points[i][0],
                                                                       fixed.points[i + 1][1] - fixed.points[i][1]));
  std::sort(fixed.points.begin(), fixed.points.end());
  fixed.points.erase(std::unique(fixed.points.begin(), fixed.points.end()), fixed.points.end());
  return fixed;
}

std::vector<FixedSide> fixedSides(int body, const std::vector<MatchingSides>& matching, const std::vector<Mesh>& made)
{
  std::vector<FixedSide> fixed;
  for (const MatchingSides& sides : matching)
    if (sides.second == body)
      fixed.push_back(fixedSide(sides.secondSide, made[std::size_t(sides.first)], sides.firstSide));
  return fixed;
}

std::string fileOf(std::size_t body, const std::filesystem::path& folder)
{
  return (folder / fmt::format("{}.mesh", body)).string();
}

/// Leaves a mesh in a file, a whole one only, so that the parent sees how far the child came.
void keep(const Mesh& mesh, std::size_t body, const std::filesystem::path& folder)
{
  const std::filesystem::path unfinished = folder / "unfinished";
  std::ofstream(unfinished, std::ios::binary) << toBytes(mesh);
  std::filesystem::rename(unfinished, fileOf(body, folder));
}

void makePlaneMeshes(const std::vector<MeshScript>& scripts, const std::vector<MatchingSides>& matching,
                     const SceneLengths& lengths, GmshAlgorithm algorithm, const std::filesystem::path& folder)
{
  std::vector<Mesh> made;
  for (std::size_t b = 0; b < scripts.size(); ++b) {
    made.push_back(
        GmshGeometry(scripts[b])
            .mesh(lengths.ofBody(b), fixedSides(int(b), matching, made), algorithm, (folder / "gmsh.msh").string()));
    keep(made.back(), b, folder);
  }
}

/// Bodies of one script as one model.
std::vector<Mesh> meshSolids(const std::vector<MeshScript>& scripts, const std::vector<MatchingSides>& matching,
                             const SceneLengths& lengths, GmshAlgorithm algorithm, const std::filesystem::path& folder)
{
  std::map<std::string, std::vector<std::size_t>> bodiesOf;
  for (std::size_t b = 0; b < scripts.size(); ++b)
    bodiesOf[scripts[b].file].push_back(b);
  std::vector<Mesh> meshes(scripts.size());
  for (const auto& [file, bodies] : bodiesOf) {
    std::vector<MeshScript> parts;
    std::vector<const LengthField*> fields;
    std::map<int, std::size_t> place;
    for (const std::size_t b : bodies) {
      place[int(b)] = parts.size();
      parts.push_back(scripts[b]);
      fields.push_back(&lengths.ofBody(b));
    }
    GmshSolids solids(std::move(parts));
    for (const MatchingSides& sides : matching)
      if (place.count(sides.first) > 0 && place.count(sides.second) > 0)
        solids.requireCommonFace(place[sides.first], place[sides.second]);
    std::vector<Mesh> made = solids.mesh(fields, algorithm, (folder / "gmsh.msh").string());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      keep(made[i], bodies[i], folder);
      meshes[bodies[i]] = std::move(made[i]);
    }
  }
  return meshes;
}

/// Lengths are corrected twice, after which sizes hardly change; where gmsh gives up then, the last mesh is good
/// enough.
void makeSolids(const std::vector<MeshScript>& scripts, const std::vector<MatchingSides>& matching,
                const SceneLengths& lengths, GmshAlgorithm algorithm, const std::filesystem::path& folder)
{
  constexpr int corrections = 2;
  std::vector<Mesh> made = meshSolids(scripts, matching, lengths, algorithm, folder);
  std::optional<SceneLengths> given;
  std::vector<WantedMesh> next; // what `given` refers to
  try {
    for (int k = 0; k < corrections; ++k) {
      std::vector<WantedMesh> corrected;
      for (std::size_t b = 0; b < made.size(); ++b)
        corrected.push_back(correctedLengths(lengths.ofBody(b), given ? given->ofBody(b) : lengths.ofBody(b), made[b]));
      given.reset();
      next = std::move(corrected);
      given.emplace(next, matching);
      made = meshSolids(scripts, matching, *given, algorithm, folder);
    }
  } catch (const GmshGaveUp&) {
  }
}

[[noreturn]] void refuse(const MeshScript& script, const std::string& failure, bool gaveUp)
{
  const Diagnostic mistake = script.list.mistake("File", fmt::format("{}: {}", script.file, failure));
  if (gaveUp)
    throw RemeshFailure(mistake);
  throw InputError(mistake);
}

ChildLimits limitsFor(const std::vector<MeshScript>& scripts)
{
  ChildLimits limits{freeMemory(), 0, 0};
  for (const MeshScript& script : scripts) {
    limits.cpuSeconds += script.maximumSeconds;
    limits.mayStartPrograms = limits.mayStartPrograms && script.list.get<bool>("Allow Commands");
  }
  limits.wallSeconds = 20 * std::min(limits.cpuSeconds, 100'000);
  return limits;
}

} // namespace

std::vector<Mesh> remesh(const std::vector<MeshScript>& scripts, const std::vector<MatchingSides>& matching,
                         const std::vector<WantedMesh>& wanted, GmshAlgorithm algorithm)
{
  NDFRAME_ASSERT(scripts.size() == wanted.size(), "a script for every body");
  const SceneLengths lengths(wanted, matching);
  const bool isSolid = wanted.front().background.dim == 3;
  const Scratch folder(makeScratchFolder());
  const ChildLimits limits = limitsFor(scripts);
  std::string failure;
  bool gaveUp = true;
  try {
    const auto work = [&]() -> std::string {
      try {
        (isSolid ? makeSolids : makePlaneMeshes)(scripts, matching, lengths, algorithm, folder.path());
        return {};
      } catch (const GmshGaveUp& error) {
        return error.what();
      }
    };
    failure = runInChild(work, "gmsh", limits);
  } catch (const ChildFailure& error) {
    failure = gmshAdvice(error, limits);
    gaveUp = error.kind() == ChildFailure::Kind::Crashed;
  } catch (const FileError& error) {
    failure = error.what();
    gaveUp = false;
  }
  std::vector<Mesh> meshes;
  for (std::size_t b = 0; b < scripts.size(); ++b) {
    if (!std::filesystem::exists(fileOf(b, folder.path())))
      refuse(scripts[b], failure, gaveUp);
    meshes.push_back(meshFromBytes(readText(fileOf(b, folder.path()))));
    const auto defects = checkMesh(meshes.back());
    if (!defects.empty())
      refuse(scripts[b], defects.front(), true);
  }
  return meshes;
}

} // namespace ndframe
