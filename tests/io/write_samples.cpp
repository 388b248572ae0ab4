// Writes the files that read_back.py looks at: write_samples FOLDER.

#include <algorithm>
#include <array>
#include <string>

#include "io/sample_meshes.hpp"
#include "ndframe/io/exodus_pieces.hpp"

namespace
{

using namespace ndframe;

const std::array<std::string, 2> bodyNames{"punch", "a foundation whose name is longer than 32 characters"};

/// A function of position, body and step that read_back.py knows too.
double sampleValue(const std::vector<double>& point, int body, double time)
{
  return point[0] + 10.0 * point[1] + 100.0 * body + 1000.0 * time;
}

template <class Vertices>
std::vector<double> centroid(const Mesh& mesh, const Vertices& vertices, int count)
{
  std::vector<double> center(std::size_t(mesh.dim), 0.0);
  for (int v = 0; v < count; ++v)
    for (int i = 0; i < mesh.dim; ++i)
      center[std::size_t(i)] += mesh.point(vertices[v])[i] / count;
  return center;
}

Vector atNodes(const NodeMap& nodes, int body, double time)
{
  Vector values;
  for (int n = 0; n < nodes.numNodes(); ++n) {
    const auto x = nodes.point(n);
    values.push_back(sampleValue({x.begin(), x.begin() + nodes.dim}, body, time));
  }
  return values;
}

Vector atCells(const Mesh& mesh, int body, double time)
{
  Vector values;
  for (int c = 0; c < mesh.numCells(); ++c)
    values.push_back(sampleValue(centroid(mesh, mesh.cell(c), mesh.dim + 1), body, time));
  return values;
}

Vector atFacets(const Mesh& mesh, const std::vector<Facet>& facets, int body, double time)
{
  Vector values;
  for (const auto& facet : facets) {
    std::array<int, 3> vertices{};
    facetVertices(mesh, facet, vertices.data());
    values.push_back(sampleValue(centroid(mesh, vertices.data(), mesh.dim), body, time));
  }
  return values;
}

ExodusStep sampleStep(const std::vector<ExodusBody>& bodies, const std::vector<ExodusContactSide>& contacts,
                      double time)
{
  ExodusStep step;
  step.time = time;
  for (int b = 0; b < int(bodies.size()); ++b) {
    const Mesh& mesh = *bodies[std::size_t(b)].mesh;
    const NodeMap& nodes = *bodies[std::size_t(b)].nodes;
    auto negative = atNodes(nodes, b, time);
    std::for_each(negative.begin(), negative.end(), [](double& value) { value = -value; });
    step.nodal.push_back({{"disp_x", atNodes(nodes, b, time)}, {"disp_y", negative}});
    step.element.push_back({{"von_mises", atCells(mesh, b, time)}});
  }
  for (const auto& side : contacts)
    step.contactSide.push_back(
        {{"contact_pressure", atFacets(*bodies[std::size_t(side.body)].mesh, side.facets, side.body, time)}});
  step.global = {{"energy", {time / 4.0}}, {"contact_force", {-time}}};
  return step;
}

/// Pieces of a file, as many at a time as `counts` says.
struct Pieces
{
  std::vector<int> counts;
  bool hasRegions;
};

/// Every second cell of a body belongs to another part.
std::vector<ExodusPart> regionsOf(const Mesh& mesh)
{
  std::vector<ExodusPart> parts{{"odd", {}}, {"even", {}}};
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    parts[std::size_t(cell) % 2].cells.push_back(cell);
  return parts;
}

void writeSample(const std::string& path, int dim, int order, const Pieces& pieces)
{
  const std::array<Mesh, 2> meshes{test::sampleMesh(dim, 1.0), test::sampleMesh(dim, 0.0)};
  const std::array<NodeMap, 2> nodes{makeNodeMap(meshes[0], order), makeNodeMap(meshes[1], order)};
  std::vector<ExodusBody> bodies{{bodyNames[0], &meshes[0], &nodes[0]}, {bodyNames[1], &meshes[1], &nodes[1]}};
  if (pieces.hasRegions)
    bodies.back().parts = regionsOf(meshes[1]);
  const std::vector<ExodusContactSide> contacts{{"contact", 0, meshes[0].findSide("low")->facets},
                                                {"contact, seen from below", 1, meshes[1].findSide("high")->facets},
                                                {"lost contact", 1, {}}};
  const std::vector<ExodusStep> steps{sampleStep(bodies, contacts, 1.0), sampleStep(bodies, contacts, 2.0)};
  const std::vector<std::string> info{"first line", std::string(78, 'a') + "\u00e9" + std::string(100, 'b'), "last"};
  const std::string title = "Sample of two bodies";
  writeExodus(path, title, bodies, contacts, steps, info);
  for (const int count : pieces.counts) {
    const ExodusSharing sharing = shareCells(bodies, count);
    for (int piece = 0; piece < count; ++piece)
      writeExodusPiece(pieceName(path, count, piece), title, bodies, contacts, steps, info, sharing, piece);
  }
}

} // namespace

int main(int, char** argv)
{
  const std::string folder = argv[1];
  for (const int dim : {2, 3})
    for (const int order : {1, 2}) {
      const std::string ending = std::to_string(dim) + "-" + std::to_string(order) + ".e";
      writeSample(folder + "/sample-" + ending, dim, order, {{}, false});
      writeSample(folder + "/pieces-" + ending, dim, order, {{1, 2, 3, dim == 2 ? 8 : 12}, order == 2});
    }
  return 0;
}
