#include "ndframe/interface/facing_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "rays.hpp"
#include "searched_sides.hpp"

namespace ndframe
{
namespace
{

/// Edges face each other when the cosine of the angle between their normals is below: 25 degrees.
constexpr double facing = -0.9063;
/// Shorter parts, relative to the shorter side, are corners that meet.
constexpr double positive = 1e-6;
/// Shorter stretches of an edge are round-off.
constexpr double roundOff = 1e-9;

/// An edge that a ray may meet from outside its body.
struct Target
{
  std::size_t part;
  const SideEdge* edge;
};

/// A stretch of a first edge that faces a second one.
struct FacingStretch
{
  std::size_t part; ///< of the second edge
  double from, to;  ///< places on the first edge
  double length;
  std::array<double, 2> openings;
};

/// Looks from the edges of one part at all others.
class Search
{
public:
  Search(const std::vector<SearchedBody>& bodies, double distance, double cornerAngle)
      : bodies_(bodies), distance_(distance), parts_(partsOf(bodies))
  {
    makeNearEdges(cornerAngle);
  }

  FacingSearch run()
  {
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (parts_[p].kind != PartKind::LeftOut)
        lookFrom(p);
    FacingSearch found;
    for (auto& [key, pair] : pairs_)
      if (pair.length > positive * std::min(parts_[key[2]].length, parts_[key[3]].length))
        found.pairs.push_back(std::move(pair));
    for (auto& [key, unnamed] : unnamed_)
      if (unnamed.length > positive * std::min(parts_[key[2]].length, parts_[key[3]].length))
        found.unnamed.push_back(unnamed);
    return found;
  }

private:
  /// Two bodies, and the parts of their boundaries.
  using Key = std::array<std::size_t, 4>;

  Key keyOf(std::size_t first, std::size_t second) const
  {
    return {std::size_t(parts_[first].body), std::size_t(parts_[second].body), first, second};
  }

  const Mesh& meshOf(const SearchedPart& part) const { return *bodies_[std::size_t(part.body)].mesh; }

  /// Chords may be off by more than the distance: by less than an edge.
  void makeNearEdges(double cornerAngle)
  {
    std::vector<PlaneBounds> bounds(bodies_.size());
    for (const SearchedPart& part : parts_)
      bounds[std::size_t(part.body)].add(part.bounds);
    for (SearchedPart& part : parts_) {
      bool isNear = false;
      const double reach = distance_ + longestFacet(part);
      for (std::size_t b = 0; b < bodies_.size(); ++b)
        isNear = isNear || (int(b) != part.body && bounds[b].isNear(part.bounds, reach));
      for (const SearchedPart& other : parts_) // a body touches itself with two of its sides
        isNear = isNear || (&other != &part && other.body == part.body && other.bounds.isNear(part.bounds, reach));
      if (isNear)
        makeEdges(part, meshOf(part), cornerAngle);
    }
  }

  double longestFacet(const SearchedPart& part) const
  {
    double longest = 0.0, normal[3];
    for (const Facet facet : part.facets)
      longest = std::max(longest, facetNormal(meshOf(part), facet, normal));
    return longest;
  }

  void lookFrom(std::size_t p)
  {
    const SearchedPart& part = parts_[p];
    std::vector<std::size_t> near;
    bool meetsLater = false;
    for (std::size_t q = 0; q < parts_.size(); ++q)
      if (!parts_[q].edges.empty() && part.bounds.isNear(parts_[q].bounds, distance_ + part.unsure + parts_[q].unsure))
      {
        near.push_back(q);
        meetsLater = meetsLater || q > p;
      }
    for (std::size_t e = 0; meetsLater && e < part.edges.size(); ++e)
      for (const FacingStretch& stretch : stretchesOf(p, e, near))
        record(p, part.edges[e], stretch);
  }

  std::vector<Target> targetsOf(std::size_t p, std::size_t e, const std::vector<std::size_t>& near) const
  {
    const SideEdge& edge = parts_[p].edges[e];
    const Direction n = normalAt(edge, 0.5);
    std::vector<Target> targets;
    for (const std::size_t q : near)
      for (std::size_t k = 0; k < parts_[q].edges.size(); ++k) {
        const SideEdge& other = parts_[q].edges[k];
        const double reach = distance_ + uncertainty(edge) + uncertainty(other);
        if ((p != q || e != k) && parts_[p].edgeBounds[e].isNear(parts_[q].edgeBounds[k], reach) &&
            dotProduct(n, ownNormal(other)) < 0.0)
          targets.push_back({q, &other});
      }
    return targets;
  }

  std::vector<FacingStretch> stretchesOf(std::size_t p, std::size_t e, const std::vector<std::size_t>& near) const
  {
    const SideEdge& edge = parts_[p].edges[e];
    const std::vector<Target> targets = targetsOf(p, e, near);
    std::vector<double> places{0.0, 1.0};
    for (const Target& target : targets)
      for (const Direction& end : target.edge->ends)
        if (const auto s = rayThrough(edge, end))
          places.push_back(std::clamp(*s, 0.0, 1.0));
    std::sort(places.begin(), places.end());
    std::vector<FacingStretch> stretches;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (places[i + 1] - places[i] <= roundOff)
        continue;
      const Target* met = firstMet(p, edge, 0.5 * (places[i] + places[i + 1]), targets);
      if (met != nullptr && met->part > p) // parts are in the order of bodies
        addStretch(stretches, edge, places[i], places[i + 1], *met);
    }
    return stretches;
  }

  /// What the ray from s meets first. Where bodies overlap that is behind x, unless it is the body's own other side.
  const Target* firstMet(std::size_t p, const SideEdge& edge, double s, const std::vector<Target>& targets) const
  {
    const Direction x = edge.at(s), n = normalAt(edge, s);
    const Target *ahead = nullptr, *behind = nullptr;
    double toAhead = HUGE_VAL, toBehind = HUGE_VAL;
    for (const Target& target : targets) {
      const auto hit = meet(x, n, *target.edge);
      if (!hit || hit->place < 0.0 || hit->place > 1.0)
        continue;
      const bool isAhead = hit->distance >= 0.0;
      double& nearest = isAhead ? toAhead : toBehind;
      if (std::abs(hit->distance) < nearest) {
        nearest = std::abs(hit->distance);
        (isAhead ? ahead : behind) = &target;
      }
    }
    const bool overlaps = behind != nullptr && toBehind < toAhead && parts_[behind->part].body != parts_[p].body;
    return overlaps ? behind : ahead;
  }

  /// The part of a stretch that is within reach; the opening is linear along it.
  void addStretch(std::vector<FacingStretch>& stretches, const SideEdge& edge, double from, double to,
                  const Target& met) const
  {
    if (dotProduct(ownNormal(edge), ownNormal(*met.edge)) > facing)
      return;
    const auto opening = [&](double s) { return meet(edge.at(s), normalAt(edge, s), *met.edge)->distance; };
    const double a = opening(from), b = opening(to);
    const double reach = distance_ + uncertainty(edge) + uncertainty(*met.edge);
    double low = 0.0, high = std::abs(a) <= reach ? 1.0 : 0.0; // of the stretch
    if (a != b) {
      const auto [first, last] = std::minmax({(-reach - a) / (b - a), (reach - a) / (b - a)});
      low = std::max(0.0, first);
      high = std::min(1.0, last);
    }
    if (high <= low)
      return;
    const double begin = from + low * (to - from), end = from + high * (to - from);
    stretches.push_back({met.part, begin, end, (end - begin) * edge.length(), {a + low * (b - a), a + high * (b - a)}});
  }

  void record(std::size_t p, const SideEdge& edge, const FacingStretch& stretch)
  {
    const SearchedPart &first = parts_[p], &second = parts_[stretch.part];
    if (second.kind == PartKind::LeftOut)
      return;
    if (first.kind == PartKind::Unnamed || second.kind == PartKind::Unnamed)
      return recordUnnamed(p, edge, stretch);
    const auto [smallest, largest] = std::minmax(stretch.openings[0], stretch.openings[1]);
    const auto [at, isNew] = pairs_.insert(
        {keyOf(p, stretch.part), {first.body, second.body, first.side, second.side, 0.0, smallest, largest}});
    FacingPair& pair = at->second;
    pair.length += stretch.length;
    pair.smallest = std::min(pair.smallest, smallest);
    pair.largest = std::max(pair.largest, largest);
  }

  void recordUnnamed(std::size_t p, const SideEdge& edge, const FacingStretch& stretch)
  {
    const int first = parts_[p].body, second = parts_[stretch.part].body;
    const bool isFirst = parts_[p].kind == PartKind::Unnamed;
    UnnamedFacing& found = unnamed_[keyOf(p, stretch.part)];
    double& longest = longestUnnamed_[keyOf(p, stretch.part)];
    if (stretch.length > longest) {
      longest = stretch.length;
      found.place = edge.at(0.5 * (stretch.from + stretch.to));
    }
    found.body = isFirst ? first : second;
    found.other = isFirst ? second : first;
    found.length += stretch.length;
  }

  const std::vector<SearchedBody>& bodies_;
  const double distance_;
  std::vector<SearchedPart> parts_;
  std::map<Key, FacingPair> pairs_;
  std::map<Key, UnnamedFacing> unnamed_;
  std::map<Key, double> longestUnnamed_;
};

} // namespace

FacingSearch searchFacing(const std::vector<SearchedBody>& bodies, double distance, double cornerAngle)
{
  return Search(bodies, distance, cornerAngle).run();
}

double extentOf(const std::vector<SearchedBody>& bodies)
{
  std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, size{};
  for (const SearchedBody& body : bodies)
    for (int v = 0; v < body.mesh->numPoints(); ++v)
      for (std::size_t k = 0; k < std::size_t(body.mesh->dim); ++k) {
        low[k] = std::min(low[k], body.mesh->point(v)[k]);
        high[k] = std::max(high[k], body.mesh->point(v)[k]);
        size[k] = high[k] - low[k];
      }
  return std::hypot(size[0], size[1], size[2]);
}

} // namespace ndframe
