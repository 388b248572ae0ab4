#include "add_interface.hpp"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/help.hpp"
#include "ndframe/interface/normal_field.hpp"

namespace ndframe
{
namespace
{

int findBody(const Model& model, const InterfaceSettings& settings, ContactRole role, Diagnostics& diagnostics)
{
  const bool isDirichlet = role == ContactRole::Dirichlet;
  const std::string& name = isDirichlet ? settings.dirichletBody : settings.neumannBody;
  const int index = model.bodyIndex(name);
  if (index >= 0)
    return index;
  std::vector<std::string> names;
  for (const auto& body : model.bodies)
    names.push_back(body.name);
  const auto nearest = nearestName(name, names);
  diagnostics.add(
      settings.place.mistake(isDirichlet ? "Dirichlet Body" : "Neumann Body",
                             fmt::format("there is no body \"{}\"; {}", name,
                                         nearest.empty() ? fmt::format("the bodies are: {}.", fmt::join(names, ", "))
                                                         : fmt::format("did you mean \"{}\"?", nearest))));
  return -1;
}

/// Gives an interface the normals of its first mesh; false where it is not the same polygon any more.
bool keepNormals(InterfaceMesh& interface, std::shared_ptr<const InterfaceMesh> first)
{
  const bool turn = !interface.endNormals.empty() || !first->endNormals.empty();
  if (turn && !inheritNormals(interface, *first))
    return false;
  if (turn)
    interface.firstMesh = std::move(first);
  return true;
}

/// A side that is the polygon it was before, or as drawn, keeps the normals of the mesh that it had first.
void keepNormals(InterfaceMesh& interface, const InterfaceSettings& settings, const SidePairing& pairing,
                 const std::vector<InterfaceMesh>& earlier)
{
  if (pairing.drawn && !keepNormals(interface, pairing.drawn))
    throw InputError(settings.place.mistake(
        "", "the sides were cut to match, and what is cut does not lie on the bent side as it is drawn, which gives "
            "the directions of contact: give the meshes of both bodies the same Refine."));
  for (const InterfaceMesh& before : earlier)
    if (before.name == interface.name && (before.firstMesh || !before.endNormals.empty()))
      keepNormals(interface, before.firstMesh ? before.firstMesh : std::make_shared<const InterfaceMesh>(before));
}

/// Per interface node whether supports hold neither of its bodies there.
std::vector<char> withoutSupports(const Model& model, const InterfaceMesh& interface)
{
  const auto isHeld = [&](int body, int node) { return model.constraints[std::size_t(body)].nodes().count(node) > 0; };
  std::vector<char> without;
  for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i)
    without.push_back(!isHeld(interface.dirichlet().body, interface.dirichlet().nodes[i]) &&
                      !isHeld(interface.neumann().body, interface.neumann().nodes[i]));
  return without;
}

void refuseMeans(const InterfaceMesh& interface, const InterfaceSettings& settings, const BodyModel& neumann)
{
  const std::string reason = !interface.isMortar  ? ""
                             : interface.dim == 3 ? "Mortar is for plane scenes; the sides of solids are cut: use Cut."
                             : neumann.isRigid
                                 ? fmt::format("\"{}\" is rigid and has no mesh to match: remove this.", neumann.name)
                                 : "";
  if (!reason.empty())
    throw InputError(settings.pairing.mistake("Type", reason));
}

} // namespace

void addInterface(Model& model, const InterfaceSettings& settings, const SidePairing& pairing,
                  const std::vector<InterfaceMesh>& earlier, Diagnostics& diagnostics)
{
  NDFRAME_ASSERT(!settings.isTied, "tied bodies are one before a scene is built");
  const int first = findBody(model, settings, ContactRole::Dirichlet, diagnostics);
  const int second = findBody(model, settings, ContactRole::Neumann, diagnostics);
  if (first < 0 || second < 0)
    return;
  const auto &dirichlet = model.bodies[std::size_t(first)], &neumann = model.bodies[std::size_t(second)];
  if (dirichlet.mesh.dim != neumann.mesh.dim)
    throw InputError(settings.place.mistake("", fmt::format("\"{}\" is {}-D and \"{}\" is {}-D.", dirichlet.name,
                                                            dirichlet.mesh.dim, neumann.name, neumann.mesh.dim)));
  if (first == second && settings.dirichletSide == settings.neumannSide)
    throw InputError(settings.place.mistake(
        "Neumann Side", fmt::format("a side cannot touch itself; name two sides of \"{}\".", dirichlet.name)));
  InterfaceMesh interface =
      pairing.map     ? pairFacing(settings, dirichlet, neumann, pairing.map, pairing.gap)
      : pairing.isCut ? pairCutSides(settings, dirichlet, neumann)
                      : pairSides(settings, dirichlet, neumann, pairing.surface ? &*pairing.surface : nullptr);
  interface.isMortar = settings.isMortar;
  refuseMeans(interface, settings, neumann);
  if (!interface.map)
    keepNormals(interface, settings, pairing, earlier);
  interface.sides[0].body = first;
  interface.sides[1].body = second;
  if (diagnostics.empty() && interface.dim == 2) // else constraints may be missing
    splitCorners(interface, dirichlet.mesh, settings.cornerAngle, withoutSupports(model, interface));
  addDrawnGap(settings, interface);
  model.interfaces.push_back(std::move(interface));
}

void refuseSharedFacets(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  std::map<std::array<int, 3>, const InterfaceMesh*> taken; // by body, cell and local number
  for (const auto& interface : model.interfaces)
    for (const InterfaceSide& side : interface.sides)
      for (const Facet facet : side.facets) {
        const auto [before, isNew] = taken.insert({{side.body, facet.cell, facet.local}, &interface});
        if (isNew)
          continue;
        const BodyModel& owner = model.bodies[std::size_t(side.body)];
        diagnostics.add(
            scene.interface(interface.name)
                .place.mistake("", fmt::format("contains the facet at {} of \"{}\", which \"{}\" contains, too; "
                                               "leave it out of one of them (split the side).",
                                               pointText(facetCentre(owner.mesh, facet).data(), owner.mesh.dim),
                                               owner.name, before->second->name)));
        return;
      }
}

void refuseIdleInterfaces(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  for (const auto& interface : model.interfaces) {
    bool carries = false;
    for (int i = 0; i < interface.numNodes(); ++i)
      carries = carries || model.carriesContact(interface, i);
    if (!carries)
      diagnostics.add(scene.interface(interface.name)
                          .place.mistake("", "supports prescribe the normal displacement of every node on both sides: "
                                             "contact has nothing to decide here."));
  }
}

} // namespace ndframe
