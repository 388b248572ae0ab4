#include "flat_overlay.hpp"

#include <algorithm>
#include <cmath>

#include "creases.hpp"
#include "meetings.hpp"
#include "ndframe/cutting/cannot_cut.hpp"
#include "ndframe/cutting/constrained_triangulation.hpp"
#include "smoothed_triangles.hpp"

namespace ndframe
{
namespace
{

/// Vertices of the sides move by no more than this part of the shortest edge there to make triangles rounder, in so
/// many rounds.
constexpr double farthest = 0.3;
constexpr int rounds = 3;
/// The triangles of facets have their area up to this.
constexpr double wholeArea = 1e-9;

class Overlay
{
public:
  Overlay(const SideTopology& first, FacetSplits& firstSplits, const SideTopology& second, FacetSplits& secondSplits,
          const OverlayManner& manner)
      : sides_{&first, &second}, splits_{&firstSplits, &secondSplits}, manner_(manner),
        found_(findMeetings(first, second, manner))
  {
    for (std::size_t s = 0; manner.isSmooth && s < numCut(); ++s)
      loose_[s] = looseVertices(sides_[s]->mesh(), sides_[s]->facets(), found_.creases[s]);
  }

  void run()
  {
    for (const std::size_t s : {0u, 1u}) {
      numberPoints(s);
      nameEdges(s);
    }
    if (std::any_of(found_.chains.begin(), found_.chains.end(), [](const auto& ofSide) { return !ofSide.empty(); }) ||
        hasInner())
      triangulate();
    for (const std::size_t s : {0u, 1u})
      placePoints(s);
  }

private:
  std::size_t numCut() const { return manner_.ofRims ? 1 : 2; }

  void numberPoints(std::size_t s)
  {
    const int numOld = sides_[s]->mesh().numPoints();
    for (Meeting& point : found_.points)
      if (point.number[s] < 0 && point.on[s].kind != Carrier::Kind::Nothing) {
        point.number[s] = numOld + int(splits_[s]->points.size() / 3);
        splits_[s]->points.resize(splits_[s]->points.size() + 3);
      }
  }

  /// On a crease exactly: a vertex of the other side may be a little beside it.
  Vector3 placeOn(std::size_t s, const Meeting& point) const
  {
    const Carrier& on = point.on[s];
    if (on.kind != Carrier::Kind::Edge || found_.creases[s].count(sides_[s]->ends(on.number)) == 0)
      return point.x;
    Vector3 x = sides_[s]->point(sides_[s]->ends(on.number)[0]);
    const Vector3 along = minus(sides_[s]->point(sides_[s]->ends(on.number)[1]), x);
    const double t = innerProduct(minus(point.x, x), along) / innerProduct(along, along);
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += t * along[k];
    return x;
  }

  void placePoints(std::size_t s)
  {
    const int numOld = sides_[s]->mesh().numPoints();
    for (const Meeting& point : found_.points)
      if (point.number[s] >= numOld) {
        const Vector3 x = placeOn(s, point);
        std::copy(x.begin(), x.end(), splits_[s]->points.begin() + std::ptrdiff_t(point.number[s] - numOld) * 3);
      } else if (point.number[s] >= 0 && point.isMoved)
        splits_[s]->moved[point.number[s]] = point.x;
  }

  void nameEdges(std::size_t s)
  {
    for (const auto& [edge, chain] : found_.chains[s]) {
      auto& numbers = splits_[s]->edges[sides_[s]->ends(edge)];
      for (const int p : chain)
        numbers.push_back(found_.points[std::size_t(p)].number[s]);
    }
  }

  bool hasInner() const
  {
    return std::any_of(found_.points.begin(), found_.points.end(), [](const Meeting& point) {
      return point.on[0].kind == Carrier::Kind::Facet || point.on[1].kind == Carrier::Kind::Facet;
    });
  }

  void triangulate()
  {
    for (const std::size_t s : {0u, 1u})
      for (std::size_t p = 0; p < found_.points.size(); ++p)
        for (const int f : sides_[s]->facetsOf(found_.points[p].on[s]))
          ofFacet_[s][f].push_back(int(p));
    for (const auto& patch : found_.patches())
      triangulate(patch);
    for (std::size_t s = 0; s < numCut(); ++s)
      checkArea(s);
  }

  void triangulate(const std::array<std::vector<int>, 2>& patch)
  {
    const Plane plane(*sides_[0], patch[0].front());
    std::map<int, int> local; // of points
    std::vector<int> global;
    std::vector<Flat> flat;
    for (const std::size_t s : {0u, 1u})
      for (const int f : patch[s])
        for (const int p : ofFacet_[s][f])
          if (local.insert({p, int(flat.size())}).second) {
            global.push_back(p);
            flat.push_back(plane(found_.points[std::size_t(p)].x));
          }
    std::vector<std::array<int, 2>> segments;
    for (const std::size_t s : {0u, 1u})
      for (const int f : patch[s])
        for (const int edge : sides_[s]->edges(f)) {
          if (!found_.edgeCounts(s, *sides_[s], edge))
            continue;
          const std::vector<int> chain = found_.wholeChain(s, *sides_[s], edge);
          for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            segments.push_back({local.at(chain[i]), local.at(chain[i + 1])});
        }
    auto triangles = constrainedTriangulation(flat, segments);
    if (manner_.isSmooth)
      smooth(plane, global, flat, segments, triangles);
    for (const auto& triangle : triangles)
      for (std::size_t s = 0; s < numCut(); ++s)
        addTriangle(s, globalOf(global, triangle));
  }

  static std::array<int, 3> globalOf(const std::vector<int>& global, const std::array<int, 3>& triangle)
  {
    return {global[std::size_t(triangle[0])], global[std::size_t(triangle[1])], global[std::size_t(triangle[2])]};
  }

  void smooth(const Plane& plane, const std::vector<int>& global, std::vector<Flat>& flat,
              const std::vector<std::array<int, 2>>& segments, std::vector<std::array<int, 3>>& triangles)
  {
    const std::vector<Flat> before = flat;
    std::vector<Freedom> freedoms;
    for (const int p : global)
      freedoms.push_back(freedomOf(plane, found_.points[std::size_t(p)]));
    for (int round = 0; round < rounds; ++round) {
      std::vector<char> counts;
      for (const auto& triangle : triangles)
        counts.push_back(char(facetOf(0, globalOf(global, triangle)) >= 0 ||
                              (!manner_.ofRims && facetOf(1, globalOf(global, triangle)) >= 0)));
      smoothTriangles(flat, freedoms, triangles, counts);
      triangles = constrainedTriangulation(flat, segments);
    }
    for (std::size_t i = 0; i < flat.size(); ++i)
      if (flat[i] != before[i]) {
        Meeting& point = found_.points[std::size_t(global[i])];
        point.x = plane.moved(point.x, before[i], flat[i]);
        point.isMoved = true;
      }
  }

  Freedom freedomOf(const Plane& plane, const Meeting& point) const
  {
    Freedom freedom;
    for (const std::size_t s : {0u, 1u}) {
      const Carrier& on = point.on[s];
      Vector3 way{};
      if (on.kind == Carrier::Kind::Vertex) {
        const auto loose = loose_[s].find(on.number);
        const auto& around = sides_[s]->facetsOf(on);
        if (loose == loose_[s].end() || s >= numCut() ||
            std::any_of(around.begin(), around.end(), [&](int f) { return found_.used[s].count(f) == 0; }))
          return {Freedom::Kind::Fixed, {}, 0.0};
        way = loose->second;
        freedom.most = std::min(freedom.most, farthest * sides_[s]->sizeAt(on.number));
      } else if (on.kind == Carrier::Kind::Edge && found_.creases[s].count(sides_[s]->ends(on.number)) > 0) {
        const auto& ends = sides_[s]->ends(on.number);
        way = minus(sides_[s]->point(ends[1]), sides_[s]->point(ends[0]));
      }
      if (norm(way) == 0.0)
        continue;
      const Flat line = plane.along(way);
      if (freedom.kind == Freedom::Kind::OnLine &&
          std::abs(line[0] * freedom.way[1] - line[1] * freedom.way[0]) >
              samePoint * std::hypot(line[0], line[1]) * std::hypot(freedom.way[0], freedom.way[1]))
        return {Freedom::Kind::Fixed, {}, 0.0};
      freedom.kind = Freedom::Kind::OnLine;
      freedom.way = line;
    }
    return freedom;
  }

  /// The facet of side s that a triangle of points is a part of; -1 if there is none.
  int facetOf(std::size_t s, const std::array<int, 3>& triangle) const
  {
    const SideTopology& side = *sides_[s];
    const auto on = [&](std::size_t i) -> const Carrier& { return found_.points[std::size_t(triangle[i])].on[s]; };
    for (const int f : side.facetsOf(on(0))) {
      if (!side.isInFacet(on(1), f) || !side.isInFacet(on(2), f))
        continue;
      const auto& edges = side.edges(f);
      if (std::none_of(edges.begin(), edges.end(), [&](int edge) {
            return side.isInEdge(on(0), edge) && side.isInEdge(on(1), edge) && side.isInEdge(on(2), edge);
          }))
        return f;
    }
    return -1;
  }

  /// To the facet that it is a part of, if that is divided.
  void addTriangle(std::size_t s, const std::array<int, 3>& triangle)
  {
    const int f = facetOf(s, triangle);
    if (f < 0 || ofFacet_[s].at(f).size() <= 3)
      return;
    FacetSplits::Triangle numbers{};
    for (std::size_t i = 0; i < 3; ++i)
      numbers[i] = found_.points[std::size_t(triangle[i])].number[s];
    const Facet facet = sides_[s]->facet(f);
    splits_[s]->facets[{facet.cell, facet.local}].push_back(numbers);
    covered_[s][f] += triangleArea(triangle);
  }

  double triangleArea(const std::array<int, 3>& triangle) const
  {
    const auto x = [&](std::size_t i) { return found_.points[std::size_t(triangle[i])].x; };
    return 0.5 * norm(crossProduct(minus(x(1), x(0)), minus(x(2), x(0))));
  }

  /// Edges may be led through vertices, and vertices moved, so only all facets together keep their area.
  void checkArea(std::size_t s) const
  {
    double whole = 0.0, covered = 0.0;
    for (const int f : found_.used[s]) {
      whole += sides_[s]->sizeOfFacet(f) * sides_[s]->sizeOfFacet(f);
      const auto& v = sides_[s]->vertices(f);
      const auto divided = covered_[s].find(f);
      covered +=
          divided != covered_[s].end()
              ? divided->second
              : triangleArea({found_.atVertex[s].at(v[0]), found_.atVertex[s].at(v[1]), found_.atVertex[s].at(v[2])});
    }
    if (std::abs(covered - whole) > wholeArea * whole)
      throw CannotCut("the triangles of divided facets do not cover them");
  }

  std::array<const SideTopology*, 2> sides_;
  std::array<FacetSplits*, 2> splits_;
  OverlayManner manner_;
  Meetings found_;
  std::array<std::map<int, Vector3>, 2> loose_;            ///< vertices that may be moved, and along which lines
  std::array<std::map<int, std::vector<int>>, 2> ofFacet_; ///< per facet the points on it
  std::array<std::map<int, double>, 2> covered_;           ///< per facet that is divided the area of its triangles
};

} // namespace

void overlay(const Mesh& first, const std::vector<Facet>& firstFacets, FacetSplits& firstSplits, const Mesh& second,
             const std::vector<Facet>& secondFacets, FacetSplits& secondSplits, const OverlayManner& manner)
{
  const SideTopology ours(first, firstFacets), theirs(second, secondFacets);
  Overlay(ours, firstSplits, theirs, secondSplits, manner).run();
}

} // namespace ndframe
