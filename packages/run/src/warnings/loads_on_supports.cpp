#include <cmath>
#include <set>

#include <fmt/format.h>

#include "checks.hpp"

namespace ndframe
{
namespace
{

using FacetKey = std::pair<int, int>;

/// A load's part along a held direction, relative to the load, above which it is one that the support takes.
constexpr double part = 1e-6;

std::set<FacetKey> facetsOf(const Support& support, const Mesh& mesh)
{
  std::set<FacetKey> keys;
  if (!support.params().has("Side"))
    return keys;
  for (const Facet facet : support.facets(mesh))
    keys.insert({facet.cell, facet.local});
  return keys;
}

/// The load at the centre of a facet has a part along one of the directions.
bool pushesAlong(const Load& load, const Mesh& mesh, Facet facet, const std::vector<Direction>& directions)
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  Direction centre{}, normal{}, q{};
  for (int v = 0; v < mesh.dim; ++v)
    for (int k = 0; k < mesh.dim; ++k)
      centre[std::size_t(k)] += mesh.point(vertices[v])[k] / mesh.dim;
  facetNormal(mesh, facet, normal.data());
  Vector values;
  for (const auto& function : load.functions(mesh.dim))
    values.push_back(valueAt(function, mesh.dim, centre.data()));
  load.density(mesh.dim, values.data(), normal.data(), q.data());
  const double size = std::sqrt(dotProduct(q, q));
  return std::any_of(directions.begin(), directions.end(),
                     [&](const Direction& d) { return std::abs(dotProduct(q, d)) > part * size; });
}

} // namespace

/// A load on a side whose displacement along it is prescribed goes straight into the support and does nothing.
void findLoadsOnSupports(const Model& model, const SceneSettings&, Diagnostics& found)
{
  for (const auto& body : model.bodies)
    for (const auto& load : body.loads) {
      const auto* facets = load->facets(body.mesh);
      for (const auto& support : body.supports) {
        if (facets == nullptr)
          break;
        const auto held = facetsOf(*support, body.mesh);
        const auto directions = support->directions(body.mesh);
        const auto lost = std::count_if(facets->begin(), facets->end(), [&](Facet facet) {
          return held.count({facet.cell, facet.local}) > 0 && pushesAlong(*load, body.mesh, facet, directions);
        });
        if (lost > 0)
          found.add(load->params().mistake(
              "", fmt::format("{} of the {} facets of this load are held along it by the support \"{}\" ({}): there "
                              "the load goes straight into the support.",
                              lost, facets->size(), support->params().name(), support->description())));
      }
    }
}

} // namespace ndframe
