#include "ndframe/scene/tied_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cut_meshes.hpp"
#include "glue.hpp"
#include "ndframe/cutting/common_facets.hpp"
#include "ndframe/interface/interface_mesh.hpp"
#include "ndframe/meshing/refined_source.hpp"

namespace ndframe
{
namespace
{

/// Sides that are tied may be so far apart, relative to their facets, and as polygons of one curve are: by so many
/// times the distances of their chords from it.
constexpr double largestDistance = 1e-3, largestChordDistance = 2.0;

double allowedDistance(const SideMap& map, const SideSegment& segment, double facet)
{
  const auto bulge = [](const SideEdge& edge) { return std::sqrt(dotProduct(edge.bulge, edge.bulge)); };
  return largestDistance * facet +
         largestChordDistance * (bulge(map.first().edges()[std::size_t(segment.firstEdge)]) +
                                 bulge(map.second().edges()[std::size_t(segment.secondEdge)]));
}

std::string inPart(const std::string& part, const std::string& name)
{
  return part + ": " + name;
}

class TiedMesh final : public MeshSource
{
public:
  TiedMesh(const Params& list, const Registry<MeshSource>& sources) : list_(list)
  {
    for (const Params& part : list.sub("Parts").subs()) {
      names_.push_back(part.name());
      sources_.push_back(sources.build(part));
    }
    if (names_.size() < 2)
      throw InputError(list.mistake("", "ties at least two parts; name them in the list Parts."));
  }

  Mesh read() const override
  {
    Ledger nobody;
    ScriptMeshes alone(nobody);
    return readWith(alone);
  }
  Mesh readWith(ScriptMeshes& scripts) const override;

  MeshScript script() const override
  {
    throw InputError(
        list_.mistake("Type", "gmsh cannot remesh a tied mesh: choose Accuracy/Refinement/Type = Bisection."));
  }

private:
  int partNumber(const Params& joint, const char* key) const;
  std::vector<FacingSides> facingSides(const std::vector<Mesh>& parts) const;
  void join(const Params& joint, const FacingSides& sides, const std::vector<DerivedMesh>& parts, Glue& glue,
            std::vector<std::set<std::pair<int, int>>>& inside) const;
  void joinSolids(const Params& joint, const FacingSides& sides, const std::vector<DerivedMesh>& parts, Glue& glue,
                  std::vector<std::set<std::pair<int, int>>>& inside) const;
  Mesh merged(const std::vector<DerivedMesh>& parts, const Glue& glue,
              const std::vector<std::set<std::pair<int, int>>>& inside) const;

  Params list_;
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<MeshSource>> sources_;
};

int TiedMesh::partNumber(const Params& joint, const char* key) const
{
  const auto found = std::find(names_.begin(), names_.end(), joint.get<std::string>(key));
  if (found == names_.end())
    throw InputError(joint.mistake(key, fmt::format("there is no part \"{}\"; the parts are: {}.",
                                                    joint.get<std::string>(key), fmt::join(names_, ", "))));
  return int(found - names_.begin());
}

std::vector<FacingSides> TiedMesh::facingSides(const std::vector<Mesh>& parts) const
{
  std::vector<FacingSides> facing;
  for (const Params& joint : list_.sub("Joints").subs()) {
    FacingSides sides{partNumber(joint, "First Part"),
                      partNumber(joint, "Second Part"),
                      joint.get<std::string>("First Side"),
                      joint.get<std::string>("Second Side"),
                      {},
                      false};
    const Mesh &first = parts[std::size_t(sides.firstBody)], &second = parts[std::size_t(sides.secondBody)];
    if (sides.firstBody == sides.secondBody)
      throw InputError(joint.mistake("Second Part", "a part cannot be tied to itself; name two different parts."));
    for (const auto& [key, mesh] : {std::pair("First Side", &first), std::pair("Second Side", &second)})
      if (const auto name = joint.get<std::string>(key); mesh->findSide(name) == nullptr)
        throw InputError(joint.mistake(key, fmt::format("there is no side \"{}\"; {}.", name, sideNames(*mesh))));
    if (first.dim != second.dim)
      throw InputError(joint.mistake(
          "", fmt::format("a part of dimension {} cannot be tied to one of dimension {}.", first.dim, second.dim)));
    if (first.dim == 3) {
      sides.isCut = !sidesMatch(first, *first.findSide(sides.firstSide), second, *second.findSide(sides.secondSide));
      facing.push_back(std::move(sides));
      continue;
    }
    sides.map = mapBetween(sides, first, second, joint.get<double>("Corner Angle"));
    facing.push_back(std::move(sides));
  }
  return facing;
}

/// The same of solids: the facets that both sides have.
void TiedMesh::joinSolids(const Params& joint, const FacingSides& sides, const std::vector<DerivedMesh>& parts,
                          Glue& glue, std::vector<std::set<std::pair<int, int>>>& inside) const
{
  const Mesh &first = parts[std::size_t(sides.firstBody)].mesh, &second = parts[std::size_t(sides.secondBody)].mesh;
  const CommonFacets common =
      commonFacets(first, *first.findSide(sides.firstSide), second, *second.findSide(sides.secondSide));
  if (common.firstFacets.empty())
    throw InputError(joint.mistake("", fmt::format("no part of {}/{} lies on {}/{}; tied sides of solids must be flat "
                                                   "and lie on each other, or have the same nodes.",
                                                   names_[std::size_t(sides.firstBody)], sides.firstSide,
                                                   names_[std::size_t(sides.secondBody)], sides.secondSide)));
  const auto add = [&](int body, const std::vector<Facet>& facets) {
    for (const Facet facet : facets)
      inside[std::size_t(body)].insert({facet.cell, facet.local});
  };
  add(sides.firstBody, common.firstFacets);
  add(sides.secondBody, common.secondFacets);
  std::map<int, int> partner(common.vertices.begin(), common.vertices.end());
  for (const Facet facet : common.firstFacets) {
    int vertices[3];
    facetVertices(first, facet, vertices);
    for (const int vertex : vertices)
      glue.join(glue.number(sides.firstBody, vertex), glue.number(sides.secondBody, partner.at(vertex)));
  }
}

/// The vertices of facets that face each other, and the facets, which no side has any more.
void TiedMesh::join(const Params& joint, const FacingSides& sides, const std::vector<DerivedMesh>& parts, Glue& glue,
                    std::vector<std::set<std::pair<int, int>>>& inside) const
{
  const Mesh &first = parts[std::size_t(sides.firstBody)].mesh, &second = parts[std::size_t(sides.secondBody)].mesh;
  const auto pieces = facingPieces(*sides.map, first, first.findSide(sides.firstSide)->facets, second,
                                   second.findSide(sides.secondSide)->facets);
  if (pieces.empty())
    throw InputError(joint.mistake("", fmt::format("no part of {}/{} faces {}/{}; name the sides that face each other.",
                                                   names_[std::size_t(sides.firstBody)], sides.firstSide,
                                                   names_[std::size_t(sides.secondBody)], sides.secondSide)));
  for (const FacingPiece& piece : pieces) {
    int ours[3], theirs[3];
    double normal[3];
    facetVertices(first, piece.first, ours);
    facetVertices(second, piece.second, theirs);
    const double length = facetNormal(first, piece.first, normal);
    for (const std::size_t end : {0u, 1u}) {
      const int x = ours[piece.onFirst[end] < 0.5 ? 0 : 1], y = theirs[piece.onSecond[end] < 0.5 ? 0 : 1];
      const double apart = std::hypot(first.point(x)[0] - second.point(y)[0], first.point(x)[1] - second.point(y)[1]);
      if (apart > allowedDistance(*sides.map, sides.map->segments()[piece.segment], length))
        throw InputError(joint.mistake(
            "", fmt::format("the sides are apart by {:.3g} at {}, where facets are {:.3g} long; tied sides must lie on "
                            "each other: move one of the meshes, or refine both where they are curved.",
                            apart, pointText(first.point(x), 2), length)));
      glue.join(glue.number(sides.firstBody, x), glue.number(sides.secondBody, y));
    }
    inside[std::size_t(sides.firstBody)].insert({piece.first.cell, piece.first.local});
    inside[std::size_t(sides.secondBody)].insert({piece.second.cell, piece.second.local});
  }
}

Mesh TiedMesh::merged(const std::vector<DerivedMesh>& parts, const Glue& glue,
                      const std::vector<std::set<std::pair<int, int>>>& inside) const
{
  Mesh mesh;
  mesh.dim = parts.front().mesh.dim;
  std::map<int, int> vertex; // by root
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Mesh& part = parts[p].mesh;
    const int firstCell = mesh.numCells();
    for (const int v : part.cells) {
      const auto [found, isNew] = vertex.insert({glue.root(glue.number(int(p), v)), mesh.numPoints()});
      if (isNew)
        mesh.points.insert(mesh.points.end(), part.point(v), part.point(v) + mesh.dim);
      mesh.cells.push_back(found->second);
    }
    for (int cell = 0; cell < part.numCells(); ++cell) {
      std::vector<std::string> groups{names_[p]};
      if (!part.groups.kind.empty())
        for (const auto& name : part.groups.names[std::size_t(part.groups.kind[std::size_t(cell)])])
          groups.push_back(inPart(names_[p], name));
      mesh.groups.kind.push_back(mesh.groups.findOrAdd(std::move(groups)));
    }
    for (const Side& side : part.sides) {
      Side outside{inPart(names_[p], side.name), {}};
      for (const Facet facet : side.facets)
        if (inside[p].count({facet.cell, facet.local}) == 0)
          outside.facets.push_back({facet.cell + firstCell, facet.local});
      if (!outside.facets.empty())
        mesh.sides.push_back(std::move(outside));
    }
    for (const auto& note : part.notes)
      mesh.notes.push_back(inPart(names_[p], note));
  }
  return mesh;
}

Mesh TiedMesh::readWith(ScriptMeshes& scripts) const
{
  std::vector<Mesh> parts;
  for (const auto& source : sources_)
    parts.push_back(source->readWith(scripts));
  const auto facing = facingSides(parts);
  const bool isPlane = parts.front().dim == 2;
  if (isPlane)
    addSideEnds(parts, facing, std::vector<char>(parts.size(), 0), true);
  const std::vector<DerivedMesh> cut = cutMeshes(parts, facing, ListPlace(list_));
  Glue glue(cut);
  std::vector<std::set<std::pair<int, int>>> inside(parts.size()); // facets that have become inner ones
  const auto joints = list_.sub("Joints").subs();
  for (std::size_t j = 0; j < joints.size(); ++j)
    isPlane ? join(joints[j], facing[j], cut, glue, inside) : joinSolids(joints[j], facing[j], cut, glue, inside);
  Mesh mesh = merged(cut, glue, inside);
  mesh.notes.push_back(fmt::format("tied parts: {}", fmt::join(names_, ", ")));
  const auto mistakes = checkMesh(mesh);
  if (!mistakes.empty())
    throw InputError(
        list_.mistake("", fmt::format("the tied mesh is not sound: {}{}", fmt::join(mistakes, "; "),
                                      isPlane ? " The second part's vertices move onto the first side: refine both "
                                                "parts where tied sides are curved."
                                              : "")));
  return mesh;
}

} // namespace

void registerTied(Registry<MeshSource>& registry)
{
  ListSpec part;
  part.name = "PART";
  part.doc = "The mesh of one part.";
  part.choices = registry.choices();
  ListSpec parts;
  parts.name = "Parts";
  parts.doc = "What is tied, one named list each.";
  parts.isRequired = true;
  parts.each = std::make_shared<ListSpec>(part);
  ListSpec joint;
  joint.name = "JOINT";
  joint.doc = "Two sides that are glued where they face each other.";
  joint.params = {ParamSpec::required("First Part", Kind::String, "Its vertices stay where they are."),
                  ParamSpec::required("First Side", Kind::String, "Its side."),
                  ParamSpec::required("Second Part", Kind::String, "The other part."),
                  ParamSpec::required("Second Side", Kind::String, "Its side."),
                  {"Corner Angle", 35.0, inClosedRange(0.0, 180.0),
                   "In degrees. Where the sides' facets meet at a smaller angle, they represent a curve."}};
  ListSpec joints;
  joints.name = "Joints";
  joints.doc = "Where parts are glued, one named list each.";
  joints.isRequired = true;
  joints.each = std::make_shared<ListSpec>(joint);
  addMeshSource(registry, "Tied",
                "Several meshes as one, glued at sides (that need not match): what tied interfaces become. The cells "
                "of a part form a group with its name, its sides are called \"PART: SIDE\".",
                {}, [&registry](const Params& list) { return std::make_unique<TiedMesh>(list, registry); },
                {parts, joints});
}

} // namespace ndframe
