#include "sample_meshes.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe::test
{

std::vector<double> Random::vector(std::size_t size)
{
  std::vector<double> values(size);
  for (double& value : values)
    value = (*this)();
  return values;
}

std::vector<int> Random::permutation(int size)
{
  std::vector<int> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), engine_);
  return order;
}

Mesh box(const std::vector<int>& cells, const std::string& pattern, double rotation, std::vector<double> upper)
{
  upper.resize(cells.size(), 1.0);
  const auto entry = [](const char* name, const char* type, const std::string& value) {
    return fmt::format("<Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>", name, type, value);
  };
  const std::string xml =
      "<ParameterList name=\"deck\">" + entry("Type", "string", "Box") +
      entry("Lower", "Array(double)", fmt::format("{{{}}}", fmt::join(std::vector<double>(cells.size(), 0.0), ","))) +
      entry("Upper", "Array(double)", fmt::format("{{{}}}", fmt::join(upper, ","))) +
      entry("Cells", "Array(int)", fmt::format("{{{}}}", fmt::join(cells, ","))) + entry("Pattern", "string", pattern) +
      entry("Rotation", "double", fmt::format("{:.17g}", rotation)) + "</ParameterList>";
  Registry<MeshSource> registry("mesh");
  registerMeshSources(registry);
  ListSpec spec;
  spec.choices = registry.choices();
  Diagnostics diagnostics;
  const Params params = validate(parseDeck(xml, "box.xml"), spec, diagnostics);
  diagnostics.throwIfAny();
  return registry.build(params)->read();
}

Mesh moved(Mesh mesh, const std::function<void(double*)>& map)
{
  for (int p = 0; p < mesh.numPoints(); ++p)
    map(mesh.points.data() + p * mesh.dim);
  return mesh;
}

Mesh shaken(const Mesh& mesh, double amount, unsigned seed)
{
  std::set<int> onSides;
  for (const Side& side : mesh.sides)
    for (const Facet facet : side.facets) {
      int vertices[3];
      facetVertices(mesh, facet, vertices);
      onSides.insert(vertices, vertices + mesh.dim);
    }
  Mesh result = mesh;
  Random random(seed);
  for (int p = 0; p < mesh.numPoints(); ++p)
    for (int k = 0; k < mesh.dim && onSides.count(p) == 0; ++k)
      result.points[std::size_t(p * mesh.dim + k)] += amount * random();
  return result;
}

Mesh renumbered(const Mesh& mesh, unsigned seed)
{
  Random random(seed);
  const int dim = mesh.dim;
  const auto newPoint = random.permutation(mesh.numPoints()), newCell = random.permutation(mesh.numCells());
  Mesh result = mesh;
  for (int p = 0; p < mesh.numPoints(); ++p)
    std::copy_n(mesh.point(p), dim, result.points.begin() + newPoint[std::size_t(p)] * dim);
  // Turning three vertices round is an even permutation: the orientation stays.
  const auto place = [](int vertex, int cell) { return vertex < 3 ? (vertex + cell) % 3 : vertex; };
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int v = 0; v <= dim; ++v)
      result.cells[std::size_t(newCell[std::size_t(c)] * (dim + 1) + place(v, c))] =
          newPoint[std::size_t(mesh.cell(c)[v])];
  for (Side& side : result.sides) {
    for (Facet& facet : side.facets)
      facet = {newCell[std::size_t(facet.cell)], place(facet.local, facet.cell)};
    std::reverse(side.facets.begin(), side.facets.end());
  }
  return result;
}

int numBoundaryFacets(const Mesh& mesh)
{
  int sum = 0;
  for (const Side& side : mesh.sides)
    sum += int(side.facets.size());
  return sum;
}

Mesh randomCell(int dim, unsigned seed)
{
  Random random(seed);
  Mesh mesh{dim, {}, {}, {}, {}};
  for (int v = 0; v <= dim; ++v)
    mesh.cells.push_back(v);
  do
    mesh.points = random.vector(std::size_t((dim + 1) * dim));
  while (cellMeasure(mesh, 0) < 0.1);
  return mesh;
}

} // namespace ndframe::test
