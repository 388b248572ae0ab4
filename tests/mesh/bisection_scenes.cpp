#include "bisection_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <random>

#include "meshing/mesh_deck.hpp"

namespace ndframe::test
{

namespace
{

Mesh box(const char* lower, const char* upper, const char* cells, const std::string& more = {})
{
  return readMesh(text("Type", "Box") + doubles("Lower", lower) + doubles("Upper", upper) + ints("Cells", cells) +
                  more);
}

/// The same with other cells.
std::vector<Mesh> punchOf(const char* upper, const char* lower, const std::string& more = {})
{
  return {box("0.5, 1", "1.5, 2", upper, more), box("0, 0", "2, 1", lower, more)};
}

/// A small box on a large one.
std::vector<Mesh> punch(const std::string& more)
{
  return punchOf("4, 3", "8, 3", more);
}

std::vector<Mesh> mapped(std::vector<Mesh> meshes, void (*map)(double* x))
{
  for (Mesh& mesh : meshes)
    for (int p = 0; p < mesh.numPoints(); ++p)
      map(mesh.points.data() + 2 * p);
  return meshes;
}

void bend(double* x)
{
  const double old = x[0];
  x[0] += 0.2 * std::sin(2 * x[1]) + 0.05 * old * old;
  x[1] += 0.3 * std::cos(1.7 * old);
}

/// Much smaller cells on the left, up to 1 : 20.
void grade(double* x)
{
  x[0] = std::pow(x[0], 3) + 0.02 * x[0];
}

/// As good as at random at the distance of the points.
void jitter(double* x)
{
  const double phase = 37 * x[0] + 61 * x[1];
  x[0] += 0.04 * std::sin(phase);
  x[1] += 0.04 * std::cos(1.3 * phase);
}

std::vector<Mesh> fromFile(const std::string& name, const std::vector<const char*>& regions)
{
  std::vector<Mesh> meshes;
  for (const char* region : regions)
    meshes.push_back(
        readMesh(text("Type", "Gmsh") + text("File", NDFRAME_DECK_MESHES "/" + name) + strings("Regions", region)));
  return meshes;
}

/// Three triangles all of whose edges are equal up to digits. The digits put the common edge to the right of the
/// first body's lower edge or to the left of it, by whom one asks.
std::vector<Mesh> tenDigits()
{
  const double h = std::sqrt(0.75), right = h + 1e-10, left = h - 1e-10;
  return {{2, {0, 0, h, -0.5, right, 0.5}, {0, 1, 2}, {}, {}},
          {2, {0, 0, left, 0.5, 0, 1, -h, 0.5}, {0, 1, 2, 0, 2, 3}, {}, {}}};
}

std::array<double, 4> endsOf(const Mesh& mesh, Facet facet)
{
  const double* a = mesh.point(mesh.cell(facet.cell)[(facet.local + 1) % 3]);
  const double* b = mesh.point(mesh.cell(facet.cell)[(facet.local + 2) % 3]);
  return {a[0], a[1], b[0], b[1]};
}

bool lieOnEachOther(const std::array<double, 4>& a, const std::array<double, 4>& b)
{
  const double length = std::hypot(a[2] - a[0], a[3] - a[1]);
  return std::hypot(a[0] - b[2], a[1] - b[3]) + std::hypot(a[2] - b[0], a[3] - b[1]) < 1e-6 * length;
}

} // namespace

void PrintTo(const Bodies& bodies, std::ostream* stream)
{
  *stream << bodies.name;
}

const std::vector<Bodies>& bisectionScenes()
{
  static const std::vector<Bodies> scenes{
      {"Right", punch(text("Pattern", "Right"))},
      {"Alternating", punch(text("Pattern", "Alternating"))},
      {"Crossed", punch(text("Pattern", "Crossed"))},
      {"Rotated", punch(text("Pattern", "Crossed") + number("Rotation", "33"))},
      {"Bent", mapped(punch(text("Pattern", "Alternating")), bend)},
      {"Graded", mapped(punch(text("Pattern", "Right")), grade)},
      {"Jittered", mapped(punch(text("Pattern", "Crossed")), jitter)},
      {"FourAroundAPoint",
       {box("0, 0", "1, 1", "2, 3"), box("1, 0", "2, 1", "3, 3", text("Pattern", "Crossed")),
        box("0, 1", "1, 2", "2, 1", text("Pattern", "Alternating")), box("1, 1", "2, 2", "3, 1")}},
      {"Chain", {box("0, 0", "1, 0.1", "4, 1"), box("0, 0.1", "1, 0.2", "4, 1"), box("0, 0.2", "1, 1", "4, 2")}},
      {"Equilateral", {equilateral(3)}},
      {"TwoFilesOfTenDigits", tenDigits()},
      {"SingleBox", {box("-1, -1", "3, 0", "3, 2", text("Pattern", "Crossed"))}},
      {"Long", punchOf("2, 8", "4, 16")},
      {"Flat", mapped(punchOf("8, 1", "16, 2", text("Pattern", "Alternating")), jitter)},
      {"GmshFile", fromFile("punch-foundation.msh", {"punch", "foundation"})},
  };
  return scenes;
}

const std::vector<Bodies>& squareScenes()
{
  static const std::vector<Bodies> scenes{
      {"Right", punchOf("3, 3", "6, 3", text("Pattern", "Right"))},
      {"Alternating", punchOf("2, 2", "4, 2", text("Pattern", "Alternating"))},
      {"Crossed", punchOf("2, 2", "4, 2", text("Pattern", "Crossed"))},
      {"Rotated", punchOf("2, 2", "4, 2", text("Pattern", "Crossed") + number("Rotation", "33"))},
  };
  return scenes;
}

Mesh equilateral(int n)
{
  Mesh mesh{2, {}, {}, {}, {"made by hand"}};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.points.insert(mesh.points.end(), {i + 0.5 * j, std::sqrt(0.75) * j});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, c = a + n + 1;
      mesh.cells.insert(mesh.cells.end(), {a, a + 1, c, a + 1, c + 1, c});
    }
  return mesh;
}

std::vector<Facet> boundaryOf(const Mesh& mesh)
{
  std::map<std::pair<int, int>, std::vector<Facet>> facets;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int k = 0; k < 3; ++k)
      facets[std::minmax(mesh.cell(c)[(k + 1) % 3], mesh.cell(c)[(k + 2) % 3])].push_back({c, k});
  std::vector<Facet> boundary;
  for (const auto& [ends, cells] : facets)
    if (cells.size() == 1)
      boundary.push_back(cells[0]);
  return boundary;
}

double boundaryLength(const Mesh& mesh)
{
  return measure(mesh, {"", boundaryOf(mesh)});
}

std::vector<FacetTwin> findTwins(const std::vector<Mesh>& meshes)
{
  std::vector<std::vector<Facet>> boundaries;
  for (const Mesh& mesh : meshes)
    boundaries.push_back(boundaryOf(mesh));
  std::vector<FacetTwin> twins;
  for (std::size_t second = 1; second < meshes.size(); ++second)
    for (std::size_t first = 0; first < second; ++first)
      for (const Facet a : boundaries[first])
        for (const Facet b : boundaries[second])
          if (lieOnEachOther(endsOf(meshes[first], a), endsOf(meshes[second], b)))
            twins.push_back({int(first), a, int(second), b});
  return twins;
}

double lengthOf(const std::vector<FacetTwin>& twins, const std::vector<Mesh>& meshes)
{
  double sum = 0.0, normal[2];
  for (const FacetTwin& twin : twins)
    sum += facetNormal(meshes[std::size_t(twin.first)], twin.firstFacet, normal);
  return sum;
}

std::vector<std::vector<int>> randomHalvings(const std::vector<Mesh>& meshes, unsigned seed, int limit)
{
  std::mt19937 random(seed);
  std::vector<std::vector<int>> halvings = sameHalvings(meshes, 0);
  for (std::vector<int>& ofMesh : halvings) {
    for (int& number : ofMesh)
      if (random() % 10 == 0)
        number = int(random() % unsigned(limit));
    ofMesh[random() % ofMesh.size()] = limit - 1;
  }
  return halvings;
}

std::vector<std::vector<int>> sameHalvings(const std::vector<Mesh>& meshes, int number)
{
  std::vector<std::vector<int>> halvings;
  for (const Mesh& mesh : meshes)
    halvings.emplace_back(std::size_t(mesh.numCells()), number);
  return halvings;
}

std::vector<std::vector<int>> halvingsAt(const std::vector<Mesh>& meshes, double x, double y, int number)
{
  std::vector<std::vector<int>> halvings = sameHalvings(meshes, 0);
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (int c = 0; c < meshes[m].numCells(); ++c)
      for (int k = 0; k < 3; ++k) {
        const double* p = meshes[m].point(meshes[m].cell(c)[k]);
        if (std::hypot(p[0] - x, p[1] - y) < 1e-12)
          halvings[m][std::size_t(c)] = number;
      }
  return halvings;
}

std::vector<std::vector<double>> cornersOf(const Mesh& mesh)
{
  std::vector<std::vector<double>> corners;
  for (int c = 0; c < mesh.numCells(); ++c) {
    std::array<std::array<double, 2>, 3> points{};
    cellPoints(mesh, c, points[0].data());
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    corners.emplace_back(points[0].data(), points[0].data() + 6);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

double smallestAngle(const Mesh& mesh, int cell)
{
  double x[6], smallest = M_PI;
  cellPoints(mesh, cell, x);
  for (int k = 0; k < 3; ++k) {
    const double *p = x + 2 * k, *a = x + 2 * ((k + 1) % 3), *b = x + 2 * ((k + 2) % 3);
    const double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
    smallest = std::min(smallest, std::atan2(ax * by - ay * bx, ax * bx + ay * by));
  }
  return smallest;
}

} // namespace ndframe::test
