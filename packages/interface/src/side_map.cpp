#include "ndframe/interface/side_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rays.hpp"

namespace ndframe
{
namespace
{

/// Edges face each other when the cosine of the angle between n and the second one's normal is below.
constexpr double facing = -0.5;
/// Ends of edges of a curve face each other when they would leave a segment shorter than this part of the shorter edge:
/// which points of a curve face each other is a choice within this.
constexpr double sameEnd = 1e-2;
constexpr double sameEndStraight = 1e-9;
/// Those of straight edges that are apart also within this part of the shorter edge and this part of their distance:
/// edges that are not parallel have rays that lean by so much.
constexpr double sameEndApart = 1e-3, lean = 0.1;
constexpr double sameLine = 1e-9;
/// Overlaps that are smaller, relative to the shorter edge, are round-off of the coordinates; segments are nothing.
constexpr double roundOff = 1e-6;

bool faces(const SideEdge& first, const SideEdge& second)
{
  const Direction n = normalAt(first, 0.5);
  return dotProduct(n, ownNormal(second)) < facing * std::sqrt(dotProduct(n, n));
}

/// Largest extent of both polygons.
double extentOf(const SidePolygon& first, const SidePolygon& second)
{
  std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (const SidePolygon* polygon : {&first, &second})
    for (const SideEdge& edge : polygon->edges())
      for (const Direction& end : edge.ends)
        for (std::size_t k = 0; k < 2; ++k) {
          low[k] = std::min(low[k], end[k]);
          high[k] = std::max(high[k], end[k]);
        }
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

/// The nearest edge among some that the ray from s on the first edge meets.
int nearestEdge(const SideEdge& first, double s, const std::vector<SideEdge>& edges, const std::vector<int>& among,
                double reach)
{
  int nearest = -1;
  double least = reach;
  for (const int e : among)
    if (const auto hit = meet(first.at(s), normalAt(first, s), edges[std::size_t(e)]);
        hit && hit->place >= 0.0 && hit->place <= 1.0 && std::abs(hit->distance) < least)
    {
      least = std::abs(hit->distance);
      nearest = e;
    }
  return nearest;
}

/// A length: ends within it face each other.
double sameEndOf(const SideEdge& first, const SideEdge& second, double opening)
{
  const double shorter = std::min(first.length(), second.length());
  return first.turns ? sameEnd * shorter
                     : std::max(sameEndStraight * shorter, std::min(sameEndApart * shorter, lean * std::abs(opening)));
}

double snapped(double place, double tolerance)
{
  if (place < tolerance)
    return 0.0;
  return place > 1.0 - tolerance ? 1.0 : place;
}

} // namespace

SideMap::SideMap(SidePolygon first, SidePolygon second)
    : first_(std::move(first)), second_(std::move(second)), reach_(extentOf(first_, second_))
{
  for (std::size_t e = 0; e < first_.edges().size(); ++e)
    addSegments(int(e));
  keepApart();
}

void SideMap::addSegments(int firstEdge)
{
  const SideEdge& first = first_.edges()[std::size_t(firstEdge)];
  const auto& edges = second_.edges();
  std::vector<int> opposite;
  std::vector<std::pair<double, double>> ends{{0.0, 0.0}, {1.0, 0.0}}; // and how far from there is the same
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!faces(first, edges[e]))
      continue;
    opposite.push_back(int(e));
    for (const Direction& end : edges[e].ends)
      if (const auto s = rayThrough(first, end); s)
        ends.emplace_back(*s,
                          sameEndOf(first, edges[e], dotProduct(normalAt(first, *s), difference(end, first.at(*s)))));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<double> places;
  for (const auto& [s, same] : ends) {
    const double tolerance = same / first.length(), place = snapped(s, tolerance);
    if (places.empty() || place - places.back() > tolerance || place == 1.0)
      places.push_back(place);
  }
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double from = places[i], to = places[i + 1];
    const int e = to > from ? nearestEdge(first, 0.5 * (from + to), edges, opposite, reach_) : -1;
    if (e < 0)
      continue;
    SideSegment segment{firstEdge, e, {from, to}, {}};
    const SideEdge& second = edges[std::size_t(e)];
    for (std::size_t k = 0; k < 2; ++k) {
      const auto hit = meet(first.at(segment.first[k]), normalAt(first, segment.first[k]), second);
      segment.second[k] = snapped(hit->place, sameEndOf(first, second, hit->distance) / second.length());
    }
    if (segment.second[0] != segment.second[1])
      segments_.push_back(segment);
  }
}

/// No point of the second side belongs to two segments: what two of them claim is divided in the middle. A segment of
/// which nothing is left has no partner.
void SideMap::keepApart()
{
  std::vector<std::size_t> order(segments_.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto low = [this](std::size_t i) { return std::min(segments_[i].second[0], segments_[i].second[1]); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(segments_[i].secondEdge, low(i)) < std::pair(segments_[j].secondEdge, low(j));
  });
  const auto end = [](SideSegment& segment, double place, bool upper) {
    const bool isFirst = (segment.second[0] > segment.second[1]) == upper;
    const std::size_t k = isFirst ? 0 : 1;
    const double share = (place - segment.second[0]) / (segment.second[1] - segment.second[0]);
    segment.first[k] = segment.first[0] + share * (segment.first[1] - segment.first[0]);
    segment.second[k] = place;
  };
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    SideSegment &a = segments_[order[i]], &b = segments_[order[i + 1]];
    const double upper = std::max(a.second[0], a.second[1]), lower = low(order[i + 1]);
    if (a.secondEdge != b.secondEdge || lower >= upper - sameEndStraight)
      continue;
    const double middle = std::clamp(0.5 * (upper + lower), low(order[i]) + sameEndStraight,
                                     std::max(b.second[0], b.second[1]) - sameEndStraight);
    end(a, middle, true);
    end(b, middle, false);
  }
  const auto isNothing = [](const SideSegment& segment) {
    return std::abs(segment.first[1] - segment.first[0]) < roundOff ||
           std::abs(segment.second[1] - segment.second[0]) < roundOff;
  };
  segments_.erase(std::remove_if(segments_.begin(), segments_.end(), isNothing), segments_.end());
}

Direction SideMap::pointOnFirst(const SideSegment& segment, double t) const
{
  return first_.edges()[std::size_t(segment.firstEdge)].at((1.0 - t) * segment.first[0] + t * segment.first[1]);
}

Direction SideMap::pointOnSecond(const SideSegment& segment, double t) const
{
  return second_.edges()[std::size_t(segment.secondEdge)].at((1.0 - t) * segment.second[0] + t * segment.second[1]);
}

Direction SideMap::normal(const SideSegment& segment, double t) const
{
  return normalAt(first_.edges()[std::size_t(segment.firstEdge)], (1.0 - t) * segment.first[0] + t * segment.first[1]);
}

Direction SideMap::apart(const SideSegment& segment, double t, Shape shape) const
{
  if (shape == Shape::Polygons)
    return difference(pointOnSecond(segment, t), pointOnFirst(segment, t));
  return difference(
      second_.edges()[std::size_t(segment.secondEdge)].onCurve((1.0 - t) * segment.second[0] + t * segment.second[1]),
      first_.edges()[std::size_t(segment.firstEdge)].onCurve((1.0 - t) * segment.first[0] + t * segment.first[1]));
}

double SideMap::opening(const SideSegment& segment, double t, Shape shape) const
{
  return dotProduct(normal(segment, t), apart(segment, t, shape));
}

bool SideMap::isSameLine(const SideSegment& segment) const
{
  const SideEdge& first = first_.edges()[std::size_t(segment.firstEdge)];
  if (first.turns)
    return false;
  const double size = sameLine * (first.length() + second_.edges()[std::size_t(segment.secondEdge)].length());
  for (const double t : {0.0, 1.0}) {
    const Direction apart = difference(pointOnSecond(segment, t), pointOnFirst(segment, t));
    if (std::hypot(apart[0], apart[1]) > size)
      return false;
  }
  return true;
}

double SideMap::largestOpening() const
{
  double largest = 0.0, few = 0.0;
  for (const SideSegment& segment : segments_) {
    few = std::max(few, sameLine * first_.edges()[std::size_t(segment.firstEdge)].length());
    for (const double t : {0.0, 0.5, 1.0})
      largest = std::max(largest, std::abs(opening(segment, t, Shape::Polygons)));
  }
  return largest > few ? largest : 0.0;
}

bool SideMap::touches() const
{
  return std::all_of(segments_.begin(), segments_.end(), [this](const SideSegment& segment) {
    const SideEdge &first = first_.edges()[std::size_t(segment.firstEdge)],
                   &second = second_.edges()[std::size_t(segment.secondEdge)];
    const double unknown = first.unsure + second.unsure + roundOff * std::min(first.length(), second.length());
    return std::abs(opening(segment, 0.0, Shape::Curves)) <= unknown &&
           std::abs(opening(segment, 0.5, Shape::Curves)) <= unknown &&
           std::abs(opening(segment, 1.0, Shape::Curves)) <= unknown;
  });
}

std::pair<double, Direction> SideMap::deepestOverlap(Shape shape) const
{
  std::pair<double, Direction> deepest{0.0, {}};
  for (const SideSegment& segment : segments_) {
    const SideEdge &first = first_.edges()[std::size_t(segment.firstEdge)],
                   &second = second_.edges()[std::size_t(segment.secondEdge)];
    const double few = roundOff * std::min(first.length(), second.length());
    for (const double t : {0.0, 0.5, 1.0})
      if (const double found = opening(segment, t, shape); found < std::min(deepest.first, -few))
        deepest = {found, pointOnFirst(segment, t)};
  }
  return deepest;
}

SideMap::Shape SideMap::outlines() const
{
  return deepestOverlap(Shape::Curves).first < 0.0 && deepestOverlap(Shape::Polygons).first == 0.0 ? Shape::Polygons
                                                                                                   : Shape::Curves;
}

} // namespace ndframe
