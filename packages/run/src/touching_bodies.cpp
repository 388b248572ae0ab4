#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ndframe/mesh/boundary.hpp"
#include "ndframe/scene/gap_offset.hpp"
#include "warnings/body_overlap.hpp"
#include "warnings/checks.hpp"

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

/// The boundaries of the bodies; a body alone meets nobody.
std::vector<std::vector<Facet>> boundariesOf(const Model& model)
{
  std::vector<std::vector<Facet>> boundaries;
  for (std::size_t b = 0; model.bodies.size() > 1 && b < model.bodies.size(); ++b)
    boundaries.push_back(boundaryFacets(model.bodies[b].mesh));
  return boundaries;
}

/// Every pair of bodies that come near each other on these meshes.
template <class Report>
void forEveryPair(const Model& model, const std::vector<const Mesh*>& meshes,
                  const std::vector<std::vector<Facet>>& boundaries, const Report& report)
{
  if (boundaries.empty())
    return;
  auto paired = pairedFacets(model);
  for (const auto& [a, b] : nearPairs(meshes))
    if (!model.bodies[std::size_t(a)].isRigid && !model.bodies[std::size_t(b)].isRigid) // only shown by their meshes
      report(a, b,
             encounterOf({meshes[std::size_t(a)], boundaries[std::size_t(a)], paired[{a, b}]},
                         {meshes[std::size_t(b)], boundaries[std::size_t(b)], paired[{b, a}]}));
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
  forEveryPair(model, meshes, boundariesOf(model), [&](int a, int b, const Encounter& encounter) {
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

/// Bodies that their displacements bring into each other where no interface is. Limit: not of bodies that ranks share.
void findOverlaps(const Answer& answer, const RunSettings& settings, Diagnostics& found)
{
  const Run& run = answer.run;
  if (run.model.told) // no rank has the boundaries
    return;
  const auto boundaries = boundariesOf(run.model);
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
  forEveryPair(run.model, before, boundaries, [&](int a, int b, const Encounter& encounter) {
    if (encounter.depth > 0.0 || encounter.touching)
      known.insert({a, b});
  });
  forEveryPair(run.model, after, boundaries, [&](int a, int b, const Encounter& encounter) {
    if (known.count({a, b}) == 0 && encounter.depth > secondOrder * motion)
      found.add(settings.scene.interfacesPlace.mistake(
          "", fmt::format("the displacements make {} overlap, by {:.2g} near {}, where no interface "
                          "joins them. Name the sides that meet there in an interface.",
                          bodyNames(run.model, a, b), encounter.depth / factor,
                          pointText(encounter.deepest.data(), after.front()->dim))));
  });
}

} // namespace ndframe
