#include <algorithm>

#include "rays.hpp"
#include "searched_sides.hpp"

namespace ndframe
{
namespace
{

double distanceTo(const SideEdge& edge, const Direction& x)
{
  const Direction along = difference(edge.ends[1], edge.ends[0]), to = difference(x, edge.ends[0]);
  const double place = std::clamp(dotProduct(to, along) / dotProduct(along, along), 0.0, 1.0);
  const Direction apart = difference(x, edge.at(place));
  return std::hypot(apart[0], apart[1]);
}

/// The nearest so far. A corner belongs to two sides: of equally near ones those count that face each other most.
struct Candidate
{
  NearestSides sides;
  double cosine; ///< between the normals

  bool isBetterThan(const std::optional<Candidate>& other) const
  {
    if (!other)
      return true;
    const double few = 1e-9 * other->sides.distance;
    return sides.distance < other->sides.distance - few ||
           (sides.distance <= other->sides.distance + few && cosine < other->cosine);
  }
};

double reachOf(const std::optional<Candidate>& nearest)
{
  return nearest ? (1.0 + 1e-6) * nearest->sides.distance : HUGE_VAL;
}

/// Edges that do not cross are nearest at an end of one of them.
void compare(const SearchedPart& first, const SearchedPart& second, std::optional<Candidate>& nearest)
{
  for (const bool swapped : {false, true}) {
    const SearchedPart &one = swapped ? second : first, &other = swapped ? first : second;
    for (std::size_t e = 0; e < one.edges.size(); ++e)
      for (std::size_t k = 0; k < other.edges.size(); ++k) {
        if (!one.edgeBounds[e].isNear(other.edgeBounds[k], reachOf(nearest)))
          continue;
        const double cosine = dotProduct(ownNormal(one.edges[e]), ownNormal(other.edges[k]));
        for (const Direction& end : one.edges[e].ends) {
          const Candidate found{
              {first.body, second.body, first.side, second.side, distanceTo(other.edges[k], end), end}, cosine};
          if (found.isBetterThan(nearest))
            nearest = found;
        }
      }
  }
}

} // namespace

std::optional<NearestSides> nearestSides(const std::vector<SearchedBody>& bodies)
{
  std::vector<SearchedPart> parts;
  for (SearchedPart& part : partsOf(bodies))
    if (part.kind == PartKind::Named) {
      makeEdges(part, *bodies[std::size_t(part.body)].mesh, 0.0);
      parts.push_back(std::move(part));
    }
  std::optional<Candidate> nearest;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t q = p + 1; q < parts.size(); ++q)
      if (parts[q].body > parts[p].body && parts[p].bounds.isNear(parts[q].bounds, reachOf(nearest)))
        compare(parts[p], parts[q], nearest);
  return nearest ? std::optional(nearest->sides) : std::nullopt;
}

} // namespace ndframe
