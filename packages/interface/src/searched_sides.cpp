#include "searched_sides.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{
namespace
{

/// Relative to an edge.
constexpr double roundOff = 1e-6;

using FacetSet = std::set<std::pair<int, int>>;

double lengthOf(const Mesh& mesh, const Side& side)
{
  double sum = 0.0, normal[3];
  for (const Facet facet : side.facets)
    sum += facetNormal(mesh, facet, normal);
  return sum;
}

FacetSet facetsOf(const Side& side)
{
  FacetSet facets;
  for (const Facet facet : side.facets)
    facets.insert({facet.cell, facet.local});
  return facets;
}

/// Whether the largest sides that are parts of this one make it, without a facet twice.
bool isMadeOfParts(std::size_t side, const std::vector<FacetSet>& sides)
{
  const auto isPartOf = [&](std::size_t a, std::size_t b) {
    return sides[a].size() < sides[b].size() &&
           std::includes(sides[b].begin(), sides[b].end(), sides[a].begin(), sides[a].end());
  };
  FacetSet covered;
  for (std::size_t part = 0; part < sides.size(); ++part) {
    bool isLargest = isPartOf(part, side);
    for (std::size_t other = 0; isLargest && other < sides.size(); ++other)
      isLargest = !(isPartOf(part, other) && isPartOf(other, side)) && !(other < part && sides[other] == sides[part]);
    for (const auto& facet : isLargest ? sides[part] : FacetSet())
      if (!covered.insert(facet).second)
        return false;
  }
  return covered == sides[side];
}

/// Preferred sides, then the longest first, without those that are made of others: where a side is split at the ends
/// of what it faces, its parts match.
std::vector<const Side*> inOrderOfChoice(const SearchedBody& body)
{
  std::vector<FacetSet> facets;
  for (const Side& side : body.mesh->sides)
    facets.push_back(facetsOf(side));
  std::vector<std::pair<double, const Side*>> sides;
  for (std::size_t s = 0; s < facets.size(); ++s) {
    const Side& side = body.mesh->sides[s];
    if (body.prefers(side))
      sides.emplace_back(HUGE_VAL, &side);
    else if (!isMadeOfParts(s, facets))
      sides.emplace_back(lengthOf(*body.mesh, side), &side);
  }
  std::stable_sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Side*> order;
  for (const auto& [length, side] : sides)
    order.push_back(side);
  return order;
}

SearchedPart makePart(int body, PartKind kind, const std::string& side, std::vector<Facet> facets, const Mesh& mesh)
{
  SearchedPart part{body, kind, side, std::move(facets), {}, {}, {}};
  for (const Facet facet : part.facets) {
    int vertices[3];
    facetVertices(mesh, facet, vertices);
    for (int k = 0; k < 2; ++k)
      part.bounds.add(mesh.point(vertices[k]));
  }
  return part;
}

void addParts(std::vector<SearchedPart>& parts, const SearchedBody& body, int number)
{
  FacetSet taken;
  const auto isFree = [&](const Facet& facet) { return taken.count({facet.cell, facet.local}) == 0; };
  const auto take = [&](PartKind kind, const std::string& name, const std::vector<Facet>& facets) {
    for (const Facet facet : facets)
      taken.insert({facet.cell, facet.local});
    if (!facets.empty())
      parts.push_back(makePart(number, kind, name, facets, *body.mesh));
  };
  std::vector<Facet> hidden;
  for (const Side& side : body.mesh->sides)
    if (body.leavesOut(side))
      hidden.insert(hidden.end(), side.facets.begin(), side.facets.end());
  take(PartKind::LeftOut, {}, hidden);
  for (const Side* side : inOrderOfChoice(body))
    if (std::all_of(side->facets.begin(), side->facets.end(), isFree))
      take(PartKind::Named, side->name, side->facets);
  std::vector<Facet> rest;
  for (const Facet facet : boundaryFacets(*body.mesh))
    if (isFree(facet))
      rest.push_back(facet);
  take(PartKind::Unnamed, {}, rest);
}

} // namespace

void PlaneBounds::add(const double* point)
{
  for (std::size_t k = 0; k < 2; ++k) {
    low[k] = std::min(low[k], point[k]);
    high[k] = std::max(high[k], point[k]);
  }
}

void PlaneBounds::add(const PlaneBounds& other)
{
  add(other.low.data());
  add(other.high.data());
}

bool PlaneBounds::isNear(const PlaneBounds& other, double distance) const
{
  for (std::size_t k = 0; k < 2; ++k)
    if (!(low[k] <= other.high[k] + distance && other.low[k] <= high[k] + distance))
      return false;
  return true;
}

PlaneBounds boundsOf(const SideEdge& edge)
{
  PlaneBounds bounds;
  for (const Direction& end : edge.ends)
    bounds.add(end.data());
  return bounds;
}

double uncertainty(const SideEdge& edge)
{
  return std::sqrt(dotProduct(edge.bulge, edge.bulge)) + edge.unsure + roundOff * edge.length();
}

std::vector<SearchedPart> partsOf(const std::vector<SearchedBody>& bodies)
{
  std::vector<SearchedPart> parts;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].mesh->numCells() > 0)
      addParts(parts, bodies[b], int(b));
  return parts;
}

void makeEdges(SearchedPart& part, const Mesh& mesh, double cornerAngle)
{
  part.edges = SidePolygon(mesh, part.facets, cornerAngle).edges();
  for (const SideEdge& edge : part.edges) {
    part.edgeBounds.push_back(boundsOf(edge));
    part.length += edge.length();
    part.unsure = std::max(part.unsure, uncertainty(edge));
  }
}

} // namespace ndframe
