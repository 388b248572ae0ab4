#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ndframe/assembly/share_boundary.hpp"
#include "ndframe/scene/gap_offset.hpp"
#include "warnings/body_overlap.hpp"
#include "warnings/checks.hpp"
#include "warnings/shared_overlap.hpp"

namespace ndframe
{
namespace
{

/// Deformed bodies are drawn with strains of at most this: the theory is linear, and larger motions mean nothing.
constexpr double drawnStrain = 0.01;
/// Overlaps below this part of the largest displacement are of second order: a motion times a rotation.
constexpr double secondOrder = 0.05;

/// Facets of a body by (cell, local).
using FacetSet = std::set<std::pair<int, int>>;

/// Per ordered pair of bodies the facets of the first that interfaces join to the second.
std::map<std::pair<int, int>, FacetSet> pairedFacets(const Model& model)
{
  std::map<std::pair<int, int>, FacetSet> paired;
  const auto add = [&](int body, int other, const std::vector<Facet>& facets) {
    for (const Facet facet : facets)
      paired[{body, other}].insert({facet.cell, facet.local});
  };
  for (const auto& interface : model.interfaces) {
    add(interface.dirichlet().body, interface.neumann().body, interface.dirichlet().facets);
    add(interface.neumann().body, interface.dirichlet().body, interface.neumann().facets);
  }
  return paired;
}

/// The boundaries of the bodies, of shared ones what this rank's cells have of them; a body alone meets nobody.
/// Collective where bodies are shared.
std::vector<std::vector<Facet>> boundariesOf(const Model& model, const Comm& comm)
{
  std::vector<std::vector<Facet>> boundaries;
  for (std::size_t b = 0; model.bodies.size() > 1 && b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    boundaries.push_back(body.share ? ownBoundary(body.mesh, *body.share, comm) : boundaryFacets(body.mesh));
  }
  return boundaries;
}

/// Of a body on this mesh, as another one sees it.
BoundaryView viewOf(const BodyModel& body, const Mesh* mesh, std::vector<Facet> boundary, FacetSet paired)
{
  return {mesh, std::move(boundary), std::move(paired), body.share ? body.share->numOwnCells() : -1};
}

/// Pairs of bodies that come near each other on these meshes. Collective where bodies are shared.
std::vector<std::pair<int, int>> nearBodies(const Model& model, const std::vector<const Mesh*>& meshes,
                                            const Comm& comm)
{
  if (!model.told)
    return nearPairs(meshes);
  std::vector<BoundaryView> views;
  for (std::size_t b = 0; b < meshes.size(); ++b)
    views.push_back(viewOf(model.bodies[b], meshes[b], {}, {}));
  const std::vector<Mesh> boxes = boxesOfShares(views, comm);
  std::vector<const Mesh*> all;
  for (const Mesh& box : boxes)
    all.push_back(&box);
  return nearPairs(all);
}

/// Every pair of bodies that come near each other on these meshes. Collective where bodies are shared.
template <class Report>
void forEveryPair(const Model& model, const std::vector<const Mesh*>& meshes,
                  const std::vector<std::vector<Facet>>& boundaries, const Comm& comm, const Report& report)
{
  if (boundaries.empty())
    return;
  auto paired = pairedFacets(model);
  const auto view = [&](int body, int other) {
    const auto b = std::size_t(body);
    return viewOf(model.bodies[b], meshes[b], boundaries[b], paired[{body, other}]);
  };
  for (const auto& [a, b] : nearBodies(model, meshes, comm)) {
    if (model.bodies[std::size_t(a)].isRigid || model.bodies[std::size_t(b)].isRigid) // only shown by their meshes
      continue;
    const BoundaryView one = view(a, b), other = view(b, a);
    report(a, b, model.told ? encounterOfShares(one, other, comm) : encounterOf(one, other));
  }
}

std::string bodyNames(const Model& model, int a, int b)
{
  return fmt::format("\"{}\" and \"{}\"", model.bodies[std::size_t(a)].name, model.bodies[std::size_t(b)].name);
}

/// Part of the displacements at which no strain is above what may be drawn.
double drawnPart(const std::vector<BodySummary>& bodies)
{
  double strain = 0.0;
  for (const auto& body : bodies)
    strain = std::max(strain, body.strain.value);
  return strain > drawnStrain ? drawnStrain / strain : 1.0;
}

/// A body's mesh where it is in the end: moved by displacement and offset, as pictures show it.
Mesh deformed(const Run& run, std::size_t body, const std::vector<NodalField>& offsets, double factor)
{
  Mesh mesh = run.model.bodies[body].mesh;
  const Vector& u = run.solved.fields[body].displacement.back();
  for (std::size_t i = 0; i < mesh.points.size(); ++i) // the vertices are the first nodes
    mesh.points[i] += factor * (u[i] + (offsets.empty() ? 0.0 : offsets[body][i]));
  return mesh;
}

} // namespace

/// Bodies that lie on or in each other where no interface is: nothing keeps them apart.
void findTouchingBodies(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  std::vector<const Mesh*> meshes;
  for (const auto& body : model.bodies)
    meshes.push_back(&body.mesh);
  const Comm single = Comm::single();
  forEveryPair(model, meshes, boundariesOf(model, single), single, [&](int a, int b, const Encounter& encounter) {
    const int dim = meshes.front()->dim;
    if (encounter.depth > 0.0)
      found.add(scene.bodiesPlace.mistake(
          "", fmt::format("{} overlap in the mesh, by {:.2g} at {}, where no interface joins them.",
                          bodyNames(model, a, b), encounter.depth, pointText(encounter.deepest.data(), dim))));
    else if (encounter.touching)
      found.add(scene.interfacesPlace.mistake(
          "", fmt::format("the boundaries of {} coincide at {}, and no interface joins them there: nothing keeps them "
                          "apart. Name both sides in an interface.",
                          bodyNames(model, a, b), pointText(encounter.touching->data(), dim))));
  });
}

/// Bodies that their displacements bring into each other where no interface is.
void findOverlaps(const Answer& answer, const RunSettings& settings, Diagnostics& found)
{
  const Run& run = answer.run;
  const auto boundaries = boundariesOf(run.model, answer.comm);
  const auto offsets = gapOffsets(run.model);
  const double factor = drawnPart(answer.bodies);
  double motion = 0.0;
  std::vector<Mesh> moved;
  std::vector<const Mesh*> before, after;
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    moved.push_back(deformed(run, b, offsets, factor));
    motion = std::max(motion, factor * answer.bodies[b].displacement.value);
  }
  for (std::size_t b = 0; b < moved.size(); ++b) {
    before.push_back(&run.model.bodies[b].mesh);
    after.push_back(&moved[b]);
  }
  std::set<std::pair<int, int>> known; // they touch or overlap in the mesh already
  forEveryPair(run.model, before, boundaries, answer.comm, [&](int a, int b, const Encounter& encounter) {
    if (encounter.depth > 0.0 || encounter.touching)
      known.insert({a, b});
  });
  forEveryPair(run.model, after, boundaries, answer.comm, [&](int a, int b, const Encounter& encounter) {
    if (known.count({a, b}) == 0 && encounter.depth > secondOrder * motion)
      found.add(settings.scene.interfacesPlace.mistake(
          "", fmt::format("the displacements make {} overlap, by {:.2g} near {}, where no interface "
                          "joins them. Name the sides that meet there in an interface.",
                          bodyNames(run.model, a, b), encounter.depth / factor,
                          pointText(encounter.deepest.data(), after.front()->dim))));
  });
}

} // namespace ndframe
