#include <algorithm>
#include <cmath>

#include "ndframe/interface/side_map.hpp"

namespace ndframe
{
namespace
{

/// Places nearer than this part of the shorter facet are one.
constexpr double samePlace = 1e-5;

/// A facet along an edge.
struct Placed
{
  Facet facet;
  Stretch on;

  double low() const { return std::min(on.from, on.to); }
  double high() const { return std::max(on.from, on.to); }
  double placeOnFacet(double onEdge) const { return (onEdge - on.from) / (on.to - on.from); }
};

/// Per edge its facets in order; false where a facet lies on none.
bool placeFacets(const SidePolygon& polygon, const Mesh& mesh, const std::vector<Facet>& facets,
                 std::vector<std::vector<Placed>>& ofEdges)
{
  ofEdges.resize(polygon.edges().size());
  for (const Facet facet : facets) {
    const Stretch on = polygon.locate(mesh, facet);
    if (on.edge < 0)
      return false;
    ofEdges[std::size_t(on.edge)].push_back({facet, on});
  }
  for (auto& edge : ofEdges)
    std::sort(edge.begin(), edge.end(), [](const Placed& a, const Placed& b) { return a.low() < b.low(); });
  return true;
}

/// The facets of one edge seen along a segment.
class Along
{
public:
  Along(const std::vector<Placed>& facets, const std::array<double, 2>& ends) : ends_(ends)
  {
    const double low = std::min(ends[0], ends[1]), high = std::max(ends[0], ends[1]);
    first_ = std::partition_point(facets.begin(), facets.end(), [&](const Placed& f) { return f.high() <= low; });
    last_ = std::partition_point(first_, facets.end(), [&](const Placed& f) { return f.low() < high; });
  }

  /// t of the vertices between the ends, and the shortest facet in units of t.
  void addPlaces(std::vector<double>& places, double& shortest) const
  {
    for (auto f = first_; f != last_; ++f) {
      shortest = std::min(shortest, (f->high() - f->low()) / std::abs(ends_[1] - ends_[0]));
      for (const double place : {f->low(), f->high()})
        if (const double t = (place - ends_[0]) / (ends_[1] - ends_[0]); t > 0.0 && t < 1.0)
          places.push_back(t);
    }
  }

  const Placed* at(double t) const
  {
    const double place = onEdge(t);
    const auto found = std::partition_point(first_, last_, [&](const Placed& f) { return f.high() < place; });
    return found == last_ || found->low() > place ? nullptr : &*found;
  }
  double onEdge(double t) const { return (1.0 - t) * ends_[0] + t * ends_[1]; }

private:
  std::array<double, 2> ends_;
  std::vector<Placed>::const_iterator first_, last_;
};

/// Ascending, without what is nearer than the tolerance to the one before or to 1.
std::vector<double> distinct(std::vector<double> places, double tolerance)
{
  std::sort(places.begin(), places.end());
  std::vector<double> kept{0.0};
  for (const double t : places)
    if (t - kept.back() > tolerance && 1.0 - t > tolerance)
      kept.push_back(t);
  kept.push_back(1.0);
  return kept;
}

void addPieces(std::size_t number, const Along& first, const Along& second, std::vector<FacingPiece>& pieces)
{
  std::vector<double> places;
  double shortest = 1.0;
  first.addPlaces(places, shortest);
  second.addPlaces(places, shortest);
  places = distinct(std::move(places), samePlace * shortest);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double middle = 0.5 * (places[i] + places[i + 1]);
    const Placed *one = first.at(middle), *other = second.at(middle);
    if (one == nullptr || other == nullptr) // the side was only a part of the polygon
      continue;
    FacingPiece piece{number, {places[i], places[i + 1]}, one->facet, other->facet, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      piece.onFirst[k] = one->placeOnFacet(first.onEdge(piece.at[k]));
      piece.onSecond[k] = other->placeOnFacet(second.onEdge(piece.at[k]));
    }
    pieces.push_back(piece);
  }
}

} // namespace

std::vector<FacingPiece> facingPieces(const SideMap& map, const Mesh& first, const std::vector<Facet>& firstFacets,
                                      const Mesh& second, const std::vector<Facet>& secondFacets)
{
  std::vector<std::vector<Placed>> onFirst, onSecond;
  std::vector<FacingPiece> pieces;
  if (!placeFacets(map.first(), first, firstFacets, onFirst) ||
      !placeFacets(map.second(), second, secondFacets, onSecond))
    return pieces;
  for (std::size_t s = 0; s < map.segments().size(); ++s) {
    const SideSegment& segment = map.segments()[s];
    addPieces(s, Along(onFirst[std::size_t(segment.firstEdge)], segment.first),
              Along(onSecond[std::size_t(segment.secondEdge)], segment.second), pieces);
  }
  return pieces;
}

} // namespace ndframe
