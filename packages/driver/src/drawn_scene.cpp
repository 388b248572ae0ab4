#include "drawn_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/drawing/drawn_checks.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/interface/facing_search.hpp"
#include "ndframe/meshing/gmsh_groups.hpp"

namespace ndframe
{

namespace
{

constexpr double partOfScene = 0.01; ///< sides that are so far apart face each other
constexpr double cornerAngle = 35.0; ///< as in a deck without the key

DrawnSide measured(const Mesh& mesh, const Side& side)
{
  DrawnSide drawn{side.name, {}, {}, 0.0};
  for (const Facet& facet : side.facets) {
    Vector3 normal{};
    const double measure = facetNormal(mesh, facet, normal.data());
    const auto centre = facetCentre(mesh, facet);
    for (std::size_t i = 0; i < 3; ++i) {
      drawn.centre[i] += measure * centre[i];
      drawn.normal[i] += measure * normal[i];
    }
    drawn.measure += measure;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    drawn.centre[i] /= drawn.measure;
    drawn.normal[i] /= drawn.measure;
  }
  return drawn;
}

Vector3 centreOf(const Mesh& mesh)
{
  Vector3 sum{};
  double total = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const double measure = cellMeasure(mesh, c);
    const auto centre = cellCentre(mesh, c);
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += measure * centre[i];
    total += measure;
  }
  for (double& x : sum)
    x /= total;
  return sum;
}

/// Reads the bodies of a file as a deck would.
class DrawingReader
{
public:
  DrawingReader(const std::string& drawing, const std::string& deckFile, const Components& components)
      : drawing_(drawing), deckFile_(deckFile), components_(components)
  {}

  std::vector<DrawnBody> bodies()
  {
    const auto groups = gmshCellGroups(meshList({}), scripts_);
    refuseNamesOfLists(groups);
    std::vector<DrawnBody> bodies;
    for (const std::string& group : groups)
      bodies.push_back(body(group, {group}));
    if (bodies.empty())
      bodies.push_back(body("body", {}));
    return bodies;
  }

private:
  Params meshList(const std::vector<std::string>& regions) const
  {
    DeckList mesh{"Mesh",
                  deckFile_,
                  0,
                  {{"Type", "string", "Gmsh", deckFile_, 0}, {"File", "string", drawing_, deckFile_, 0}},
                  {}};
    for (const std::string& region : regions)
      mesh.entries.push_back({"Regions", "Array(string)", "{" + region + "}", deckFile_, 0});
    DeckList material{
        "Material",
        deckFile_,
        0,
        {{"Young Modulus", "double", "1.0", deckFile_, 0}, {"Poisson Ratio", "double", "0.3", deckFile_, 0}},
        {}};
    DeckList body{"body", deckFile_, 0, {}, {std::move(mesh), std::move(material)}};
    DeckList bodies{"Bodies", deckFile_, 0, {}, {std::move(body)}};
    Diagnostics diagnostics;
    const Params deck = validate({{}, deckFile_, 0, {}, {std::move(bodies)}}, makeDeckSpec(components_), diagnostics);
    diagnostics.throwIfAny();
    return deck.sub("Bodies").sub("body").sub("Mesh");
  }

  DrawnBody body(const std::string& name, const std::vector<std::string>& regions)
  {
    Mesh mesh = components_.meshSources.build(meshList(regions))->readWith(scripts_);
    std::vector<DrawnSide> sides;
    for (const Side& side : mesh.sides)
      sides.push_back(measured(mesh, side));
    const Vector3 centre = centreOf(mesh);
    return {name, regions.empty(), std::move(mesh), centre, std::move(sides)};
  }

  const std::string drawing_, deckFile_;
  const Components& components_;
  Ledger nobody_;
  ScriptMeshes scripts_{nobody_};
};

std::vector<SearchedBody> searched(const DrawnAssembly& scene)
{
  std::vector<SearchedBody> bodies;
  for (const DrawnBody& body : scene.bodies)
    bodies.push_back({&body.mesh, {}, {}});
  return bodies;
}

/// Why no sides of plane bodies face each other, and how to mend it.
std::string whyNothingFaces(const DrawnAssembly& scene, const std::vector<UnnamedFacing>& unnamed)
{
  const auto name = [&](int body) { return scene.bodies[std::size_t(body)].name; };
  if (const auto overlap = overlapOf(scene))
    return fmt::format("\"{}\" and \"{}\" overlap at {}; draw bodies side by side", overlap->first, overlap->second,
                       pointText(overlap->place.data(), 2));
  if (!unnamed.empty())
    return fmt::format("\"{}\" and \"{}\" do at {}, where the curve of \"{}\" has no name; name it as Physical Curve",
                       name(std::min(unnamed.front().body, unnamed.front().other)),
                       name(std::max(unnamed.front().body, unnamed.front().other)),
                       pointText(unnamed.front().place.data(), 2), name(unnamed.front().body));
  const auto nearest = nearestSides(searched(scene));
  if (!nearest)
    return "name sides as Physical Curve";
  return fmt::format("the nearest are \"{}\" of \"{}\" and \"{}\" of \"{}\", {:.4g} apart; name sides that are to "
                     "touch as Physical Curve",
                     nearest->firstSide, name(nearest->firstBody), nearest->secondSide, name(nearest->secondBody),
                     nearest->distance);
}

std::vector<DrawnContact> planeContacts(const DrawnAssembly& scene)
{
  const auto bodies = searched(scene);
  const double distance = partOfScene * scene.extent;
  const FacingSearch search = searchFacing(bodies, distance, cornerAngle);
  std::vector<DrawnContact> contacts;
  for (const FacingPair& pair : search.pairs)
    contacts.push_back({std::size_t(pair.firstBody), std::size_t(pair.secondBody), pair.firstSide, pair.secondSide,
                        std::max(0.0, pair.smallest)});
  if (contacts.empty() && scene.bodies.size() > 1)
    throw InputError(fmt::format("no two named sides face each other within {:.4g}: {}.", distance,
                                 whyNothingFaces(scene, search.unnamed)));
  return contacts;
}

std::vector<DrawnContact> solidContacts(const DrawnAssembly& scene)
{
  std::vector<DrawnContact> contacts;
  for (const FacingPair& pair : searchMatching(searched(scene)).pairs)
    if (pair.firstBody != pair.secondBody)
      contacts.push_back(
          {std::size_t(pair.firstBody), std::size_t(pair.secondBody), pair.firstSide, pair.secondSide, 0.0});
  if (contacts.empty() && scene.bodies.size() > 1)
    throw InputError(
        "no two named sides of different volumes lie on each other: draw the volumes so that they touch, and "
        "name the surfaces where they do as Physical Surface. Bent ones need the same nodes: join the volumes "
        "(BooleanFragments).");
  return contacts;
}

void markSides(DrawnAssembly& scene)
{
  const auto side = [&](std::size_t body, const std::string& name) -> DrawnSide& {
    auto& sides = scene.bodies[body].sides;
    return *std::find_if(sides.begin(), sides.end(), [&](const DrawnSide& s) { return s.name == name; });
  };
  for (const DrawnContact& contact : scene.contacts) {
    side(contact.first, contact.firstSide).touches = true;
    side(contact.second, contact.secondSide).touches = true;
  }
  std::map<std::string, std::vector<DrawnSide*>> byName;
  for (DrawnBody& body : scene.bodies)
    for (DrawnSide& one : body.sides)
      if (!one.touches && one.isFlat())
        byName[one.name].push_back(&one);
  for (auto& [name, sides] : byName)
    for (DrawnSide* one : sides)
      one->isSymmetry = sides.size() > 1 && dot(one->normal, sides.front()->normal) > 1.0 - 1e-9;
}

} // namespace

DrawnAssembly readDrawing(const std::string& drawing, const std::string& deckFile, const Components& components)
{
  DrawnAssembly scene{2, 0.0, DrawingReader(drawing, deckFile, components).bodies(), {}};
  scene.dim = scene.bodies.front().mesh.dim;
  scene.extent = extentOf(searched(scene));
  refuseNamelessSides(scene);
  refuseUnconnectedParts(scene);
  scene.contacts = scene.dim == 2 ? planeContacts(scene) : solidContacts(scene);
  markSides(scene);
  return scene;
}

} // namespace ndframe
