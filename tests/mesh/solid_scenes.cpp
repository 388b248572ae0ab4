#include "solid_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe::test
{
namespace
{

Mesh box(const char* lower, const char* upper, const char* cells, const std::string& more = {})
{
  return readMesh(text("Type", "Box") + doubles("Lower", lower) + doubles("Upper", upper) + ints("Cells", cells) +
                  more);
}

/// A small box on a large one.
std::vector<Mesh> punch(const std::string& more)
{
  return {box("0, 0, 1", "1, 1, 2", "2, 2, 2", more), box("0, 0, 0", "2, 2, 1", "4, 4, 2", more)};
}

std::vector<Mesh> mapped(std::vector<Mesh> meshes, void (*map)(double* x))
{
  for (Mesh& mesh : meshes)
    for (int p = 0; p < mesh.numPoints(); ++p)
      map(mesh.points.data() + 3 * p);
  return meshes;
}

void bend(double* x)
{
  const double old = x[0];
  x[0] += 0.2 * std::sin(2 * x[1]) + 0.05 * old * x[2];
  x[2] += 0.3 * std::cos(1.7 * old);
}

/// As good as at random at the distance of the points.
void jitter(double* x)
{
  const double phase = 37 * x[0] + 61 * x[1] + 17 * x[2];
  x[0] += 0.06 * std::sin(phase);
  x[1] += 0.06 * std::cos(1.3 * phase);
  x[2] += 0.06 * std::sin(1.7 * phase);
}

/// Thin cells at the bottom, up to 1 : 20.
void grade(double* x)
{
  x[2] = std::pow(x[2], 3) + 0.02 * x[2];
}

using Corners = std::array<std::array<double, 3>, 3>;

/// Rounded, ascending.
Corners cornersOf(const Mesh& mesh, Facet facet)
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  Corners corners{};
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      corners[v][k] = std::round(1e8 * mesh.point(vertices[v])[k] + 0.3) / 1e8;
  std::sort(corners.begin(), corners.end());
  return corners;
}

} // namespace

const std::vector<Bodies>& solidScenes()
{
  static const std::vector<Bodies> scenes{
      {"Right", punch(text("Pattern", "Right"))},
      {"Alternating", {box("-1, -1, 0", "1, 1, 1", "2, 2, 1", text("Pattern", "Alternating"))}},
      {"Turned", punch(number("Rotation", "33"))},
      {"Bent", mapped(punch({}), bend)},
      {"Jittered", mapped(punch({}), jitter)},
      {"Graded", mapped(punch({}), grade)},
      {"FourAroundAnEdge",
       {box("0, 0, 0", "1, 1, 1", "2, 2, 1"), box("1, 0, 0", "2, 1, 1", "3, 2, 1"),
        box("0, 1, 0", "1, 2, 1", "2, 3, 1"), box("1, 1, 0", "2, 2, 1", "3, 3, 1")}},
      {"Layers", {box("0, 0, 0", "1, 1, 0.1", "2, 3, 1"), box("0, 0, 0.1", "1, 1, 0.2", "2, 3, 1")}},
      {"Needles", {box("0, 0, 0", "8, 1, 0.5", "1, 1, 1")}},
      {"GmshFile", {readMesh(text("Type", "Gmsh") + text("File", dataPath("cube-4.1-binary.msh")))}},
      {"Wild", randomTetrahedra(3, 4)},
  };
  return scenes;
}

Mesh kuhnCubes(int n)
{
  const std::string cells = std::to_string(n);
  return box("0, 0, 0", "1, 1, 1", (cells + ", " + cells + ", " + cells).c_str());
}

std::vector<Mesh> randomTetrahedra(unsigned seed, int number)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<Mesh> meshes;
  while (int(meshes.size()) < number) {
    Mesh mesh{3, {}, {0, 1, 2, 3}, {}, {}};
    for (int k = 0; k < 12; ++k)
      mesh.points.push_back(place(random));
    if (cellMeasure(mesh, 0) < 0.0)
      std::swap(mesh.cells[0], mesh.cells[1]);
    meshes.push_back(mesh);
  }
  return meshes;
}

double boundaryArea(const Mesh& mesh)
{
  return measure(mesh, {"", boundaryFacets(mesh)});
}

std::vector<FacetTwin> findSolidTwins(const std::vector<Mesh>& meshes)
{
  std::map<Corners, std::pair<int, Facet>> known;
  std::vector<FacetTwin> twins;
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (const Facet facet : boundaryFacets(meshes[m])) {
      const auto [found, isNew] = known.insert({cornersOf(meshes[m], facet), {int(m), facet}});
      if (!isNew)
        twins.push_back({found->second.first, found->second.second, int(m), facet});
    }
  return twins;
}

std::vector<std::vector<double>> sortedCorners(const Mesh& mesh)
{
  std::vector<std::vector<double>> corners;
  for (int c = 0; c < mesh.numCells(); ++c) {
    std::array<std::array<double, 3>, 4> points{};
    cellPoints(mesh, c, points[0].data());
    std::sort(points.begin(), points.end());
    corners.emplace_back(points[0].data(), points[0].data() + 12);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

} // namespace ndframe::test
