#include <algorithm>
#include <cmath>
#include <set>

#include "ndframe/cutting/common_facets.hpp"
#include "ndframe/interface/facing_search.hpp"
#include "ndframe/interface/interface_mesh.hpp"
#include "ndframe/mesh/boundary.hpp"
#include "ndframe/mesh/nearest_point.hpp"
#include "side_facets.hpp"

namespace ndframe
{
namespace
{

struct Box
{
  Direction low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double facet = HUGE_VAL; ///< size of the smallest
};

Box boxOf(const Mesh& mesh, const std::vector<Facet>& facets)
{
  Box box;
  for (const Facet facet : facets) {
    int vertices[3];
    double normal[3];
    facetVertices(mesh, facet, vertices);
    box.facet = std::min(box.facet, std::sqrt(facetNormal(mesh, facet, normal)));
    for (const int vertex : vertices)
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], mesh.point(vertex)[k]);
        box.high[k] = std::max(box.high[k], mesh.point(vertex)[k]);
      }
  }
  return box;
}

bool areOne(const Box& a, const Box& b)
{
  const double tolerance = samePoint * std::min(a.facet, b.facet);
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(a.low[k] - b.low[k]) <= tolerance && std::abs(a.high[k] - b.high[k]) <= tolerance))
      return false;
  return true;
}

bool touch(const Box& a, const Box& b)
{
  const double tolerance = samePoint * std::min(a.facet, b.facet);
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] + tolerance || b.low[k] > a.high[k] + tolerance)
      return false;
  return true;
}

/// Facets of a body's boundary.
struct BoundaryFacets
{
  std::vector<Facet> facets;
  std::vector<Direction> centres, normals;
  std::vector<double> areas;

  BoundaryFacets(const Mesh& mesh, const std::set<std::pair<int, int>>& without)
  {
    if (mesh.numCells() == 0) // of a rigid body
      return;
    for (const Facet facet : boundaryFacets(mesh)) {
      if (without.count({facet.cell, facet.local}) > 0)
        continue;
      facets.push_back(facet);
      const auto centre = facetCentre(mesh, facet);
      centres.push_back({centre[0], centre[1], centre[2]});
      normals.emplace_back();
      areas.push_back(facetNormal(mesh, facet, normals.back().data()));
    }
  }
};

/// A body with its sides' boxes and the facets that pairs have taken.
class Searched
{
public:
  explicit Searched(const SearchedBody& body) : body_(body)
  {
    for (const Side& side : mesh().sides) {
      boxes_.push_back(boxOf(mesh(), side.facets));
      if (body.prefers(side))
        take(side, preferred_);
      if (body.leavesOut(side))
        take(side, taken_);
    }
  }

  const Mesh& mesh() const { return *body_.mesh; }
  const Box& box(std::size_t side) const { return boxes_[side]; }
  void take(const Side& side) { take(side, taken_); }

  /// False for a side that is left out, or shares facets with one that has a partner or that counts instead.
  bool isFree(const Side& side) const
  {
    if (side.facets.empty() || body_.leavesOut(side))
      return false;
    const bool counts = body_.prefers(side);
    return std::none_of(side.facets.begin(), side.facets.end(), [&](const Facet& facet) {
      const std::pair key{facet.cell, facet.local};
      return taken_.count(key) > 0 || (!counts && preferred_.count(key) > 0);
    });
  }

  BoundaryFacets rest() const { return {mesh(), taken_}; }

private:
  static void take(const Side& side, std::set<std::pair<int, int>>& facets)
  {
    for (const Facet facet : side.facets)
      facets.insert({facet.cell, facet.local});
  }

  const SearchedBody& body_;
  std::vector<Box> boxes_;
  std::set<std::pair<int, int>> taken_, preferred_;
};

bool haveCommonFacets(const Side& one, const Side& other)
{
  std::set<std::pair<int, int>> facets;
  for (const Facet facet : one.facets)
    facets.insert({facet.cell, facet.local});
  return std::any_of(other.facets.begin(), other.facets.end(), [&](const Facet facet) {
    return facets.count({facet.cell, facet.local}) > 0;
  });
}

void addPairs(int b, int c, Searched& first, Searched& second, std::vector<FacingPair>& pairs)
{
  const auto &ours = first.mesh().sides, &theirs = second.mesh().sides;
  for (std::size_t s = 0; s < ours.size(); ++s)
    for (std::size_t t = b == c ? s + 1 : 0; t < theirs.size(); ++t) {
      if (b == c && haveCommonFacets(ours[s], theirs[t])) // two names of one side
        continue;
      if (!first.isFree(ours[s]) || !second.isFree(theirs[t]) || !areOne(first.box(s), second.box(t)) ||
          !sidesMatch(first.mesh(), ours[s], second.mesh(), theirs[t]))
        continue;
      FacingPair pair{b, c, ours[s].name, theirs[t].name};
      double normal[3];
      for (const Facet facet : ours[s].facets)
        pair.length += facetNormal(first.mesh(), facet, normal);
      pairs.push_back(std::move(pair));
      first.take(ours[s]);
      second.take(theirs[t]);
    }
}

/// Sides that were meshed apart and lie on each other, flat; one of them may lie on several others.
void addOverlaps(int b, int c, const Searched& first, const Searched& second, std::vector<FacingPair>& pairs)
{
  const auto &ours = first.mesh().sides, &theirs = second.mesh().sides;
  for (std::size_t s = 0; s < ours.size(); ++s)
    for (std::size_t t = b == c ? s + 1 : 0; t < theirs.size(); ++t) {
      if ((b == c && haveCommonFacets(ours[s], theirs[t])) || !first.isFree(ours[s]) || !second.isFree(theirs[t]) ||
          !touch(first.box(s), second.box(t)))
        continue;
      const bool isKnown = std::any_of(pairs.begin(), pairs.end(), [&](const FacingPair& pair) {
        return pair.firstBody == b && pair.secondBody == c &&
               haveCommonFacets(ours[s], *first.mesh().findSide(pair.firstSide)) &&
               haveCommonFacets(theirs[t], *second.mesh().findSide(pair.secondSide));
      });
      const double area = isKnown ? 0.0 : overlappingArea(first.mesh(), ours[s], second.mesh(), theirs[t]);
      if (area <= 0.0)
        continue;
      pairs.push_back({b, c, ours[s].name, theirs[t].name});
      pairs.back().length = area;
    }
}

/// Facets that lie on each other and are in no pair.
std::optional<UnnamedFacing> leftBetween(int b, int c, const BoundaryFacets& ours, const BoundaryFacets& theirs)
{
  if (ours.facets.empty() || theirs.facets.empty())
    return std::nullopt;
  std::vector<double> points;
  for (const Direction& centre : theirs.centres)
    points.insert(points.end(), centre.begin(), centre.end());
  const NearestPoint tree(3, std::move(points));
  UnnamedFacing left{b, c, {}};
  for (std::size_t i = 0; i < ours.facets.size(); ++i) {
    const auto [nearest, squared] = tree.find(ours.centres[i].data());
    if (std::sqrt(squared) > samePoint * std::sqrt(ours.areas[i]) ||
        dotProduct(ours.normals[i], theirs.normals[nearest]) > -0.9)
      continue;
    if (left.length == 0.0)
      left.place = ours.centres[i];
    left.length += ours.areas[i];
  }
  return left.length > 0.0 ? std::optional(left) : std::nullopt;
}

} // namespace

FacingSearch searchMatching(const std::vector<SearchedBody>& bodies)
{
  std::vector<Searched> searched(bodies.begin(), bodies.end());
  FacingSearch found;
  const int count = int(bodies.size());
  for (int b = 0; b < count; ++b)
    for (int c = b; c < count; ++c)
      addPairs(b, c, searched[std::size_t(b)], searched[std::size_t(c)], found.pairs);
  const std::size_t numMatching = found.pairs.size();
  for (int b = 0; b < count; ++b)
    for (int c = b; c < count; ++c)
      addOverlaps(b, c, searched[std::size_t(b)], searched[std::size_t(c)], found.pairs);
  for (std::size_t p = numMatching; p < found.pairs.size(); ++p) {
    const FacingPair& pair = found.pairs[p];
    Searched &first = searched[std::size_t(pair.firstBody)], &second = searched[std::size_t(pair.secondBody)];
    first.take(*first.mesh().findSide(pair.firstSide));
    second.take(*second.mesh().findSide(pair.secondSide));
  }
  for (int b = 0; b < count; ++b)
    for (int c = b + 1; c < count; ++c)
      if (const auto left = leftBetween(b, c, searched[std::size_t(b)].rest(), searched[std::size_t(c)].rest()))
        found.unnamed.push_back(*left);
  return found;
}

} // namespace ndframe
