#include "meetings.hpp"

#include <algorithm>

#include "creases.hpp"

namespace ndframe
{
namespace
{

class MeetingSearch
{
public:
  MeetingSearch(const SideTopology& first, const SideTopology& second, const OverlayManner& manner)
      : sides_{&first, &second}, manner_(manner)
  {
    found_.ofRims = manner.ofRims;
    found_.pairs = flatPairs(first, second);
    found_.creases = {creases(first.mesh()), creases(second.mesh())};
    for (const auto& ends : found_.creases[1])
      rim_.insert(ends.begin(), ends.end());
    for (const auto& pair : found_.pairs)
      for (const std::size_t s : {0u, 1u})
        found_.used[s].insert(pair[s]);
  }

  Meetings run()
  {
    for (const auto& pair : found_.pairs)
      for (const std::size_t s : {0u, 1u})
        for (const int vertex : sides_[s]->vertices(pair[s]))
          if (counts(s, vertex))
            carry(s, vertex, pair[1 - s]);
    addVertices();
    for (const auto& pair : found_.pairs)
      for (const int e : sides_[0]->edges(pair[0]))
        for (const int h : sides_[1]->edges(pair[1]))
          cross(e, h);
    for (const std::size_t s : {0u, 1u})
      chainEdges(s);
    return std::move(found_);
  }

private:
  /// Of the second side only the rims may count.
  bool counts(std::size_t s, int vertex) const { return s == 0 || !manner_.ofRims || rim_.count(vertex) > 0; }
  void carry(std::size_t s, int vertex, int facet)
  {
    Carrier& known = carriers_[s][vertex];
    const Carrier found = place(s, vertex, facet);
    const bool isNearer = found.kind == Carrier::Kind::Edge && known.kind == found.kind &&
                          distanceToEdge(s, vertex, found.number) < distanceToEdge(s, vertex, known.number);
    if (found.kind > known.kind || isNearer)
      known = found;
  }

  /// Where a vertex of side s lies on a facet of the other one.
  Carrier place(std::size_t s, int vertex, int g) const
  {
    const SideTopology &ours = *sides_[s], &theirs = *sides_[1 - s];
    const Vector3 x = ours.point(vertex);
    for (const int w : theirs.vertices(g))
      if (counts(1 - s, w) &&
          norm(minus(x, theirs.point(w))) <= samePoint * std::min(ours.sizeAt(vertex), theirs.sizeAt(w)))
        return {Carrier::Kind::Vertex, w};
    if (const int edge = nearestEdge(s, vertex, g); edge >= 0)
      return {Carrier::Kind::Edge, edge};
    if (s == 0 && manner_.ofRims)
      return {};
    const Plane plane(theirs, g);
    std::array<Flat, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = plane(theirs.point(theirs.vertices(g)[k]));
    const Flat at = plane(x);
    const double turn = areaOf(corners[0], corners[1], corners[2]) > 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 0; k < 3; ++k)
      if (turn * areaOf(corners[k], corners[(k + 1) % 3], at) <= 0.0)
        return {};
    return {Carrier::Kind::Facet, g};
  }

  /// Of a vertex of side s to an edge of the other one; infinite where it is beside none of its points.
  double distanceToEdge(std::size_t s, int vertex, int edge) const
  {
    const SideTopology& theirs = *sides_[1 - s];
    const Vector3 a = theirs.point(theirs.ends(edge)[0]), along = minus(theirs.point(theirs.ends(edge)[1]), a);
    const Vector3 from = minus(sides_[s]->point(vertex), a);
    const double t = innerProduct(from, along) / innerProduct(along, along);
    return t > 0.0 && t < 1.0 ? norm(crossProduct(from, along)) / theirs.length(edge) : HUGE_VAL;
  }

  /// The edge of a facet on which a vertex lies, or that is led through it; -1 if there is none.
  int nearestEdge(std::size_t s, int vertex, int g) const
  {
    const SideTopology &ours = *sides_[s], &theirs = *sides_[1 - s];
    int nearest = -1;
    double least = HUGE_VAL;
    for (const int h : theirs.edges(g)) {
      const double apart = distanceToEdge(s, vertex, h);
      const double within =
          found_.creases[1 - s].count(theirs.ends(h)) > 0 ? samePoint : std::max(samePoint, manner_.near);
      if (found_.edgeCounts(1 - s, theirs, h) && apart < least &&
          apart <= within * std::min(ours.sizeAt(vertex), theirs.length(h)))
      {
        nearest = h;
        least = apart;
      }
    }
    return nearest;
  }

  void addVertices()
  {
    for (const std::size_t s : {0u, 1u})
      for (const auto& [vertex, carrier] : carriers_[s]) {
        if (s == 1 && carrier.kind == Carrier::Kind::Vertex) {
          found_.atVertex[1][vertex] = found_.atVertex[0].at(carrier.number);
          continue;
        }
        Meeting point;
        point.x = sides_[s]->point(vertex);
        point.on[s] = {Carrier::Kind::Vertex, vertex};
        point.on[1 - s] = carrier;
        point.number[s] = vertex;
        if (carrier.kind == Carrier::Kind::Vertex)
          point.number[1 - s] = carrier.number;
        found_.atVertex[s][vertex] = int(found_.points.size());
        found_.points.push_back(point);
      }
  }

  /// Whether edges meet at an end of one of them.
  bool meetAtEnds(int e, int h) const
  {
    for (const int end : sides_[0]->ends(e))
      if (sides_[1]->isInEdge(carriers_[0].at(end), h))
        return true;
    for (const int end : sides_[1]->ends(h))
      if (sides_[0]->isInEdge(carriers_[1].at(end), e))
        return true;
    return false;
  }

  void cross(int e, int h)
  {
    if (!crossed_.insert({e, h}).second || !found_.edgeCounts(1, *sides_[1], h) || meetAtEnds(e, h))
      return;
    const auto ends = [](const SideTopology& side, int edge) {
      return std::pair(side.point(side.ends(edge)[0]), side.point(side.ends(edge)[1]));
    };
    const auto [a, b] = ends(*sides_[0], e);
    const auto [c, d] = ends(*sides_[1], h);
    const Vector3 ab = minus(b, a), cd = minus(d, c), ac = minus(c, a), n = crossProduct(ab, cd);
    const double squared = innerProduct(n, n);
    if (squared <=
        samePoint * samePoint * innerProduct(ab, ab) * innerProduct(cd, cd)) // parallel ones meet at ends if at all
      return;
    const double s = innerProduct(crossProduct(ac, cd), n) / squared,
                 t = innerProduct(crossProduct(ac, ab), n) / squared;
    if (s <= 0.0 || s >= 1.0 || t <= 0.0 || t >= 1.0)
      return;
    Meeting point;
    for (std::size_t k = 0; k < 3; ++k)
      point.x[k] = a[k] + s * ab[k];
    point.on = {Carrier{Carrier::Kind::Edge, e}, Carrier{Carrier::Kind::Edge, h}};
    found_.points.push_back(point);
  }

  void chainEdges(std::size_t s)
  {
    const SideTopology& side = *sides_[s];
    for (std::size_t p = 0; p < found_.points.size(); ++p)
      if (found_.points[p].on[s].kind == Carrier::Kind::Edge)
        found_.chains[s][found_.points[p].on[s].number].push_back(int(p));
    for (auto& [edge, chain] : found_.chains[s]) {
      const Vector3 start = side.point(side.ends(edge)[0]);
      std::sort(chain.begin(), chain.end(), [&](int p, int q) {
        return norm(minus(found_.points[std::size_t(p)].x, start)) <
               norm(minus(found_.points[std::size_t(q)].x, start));
      });
    }
  }

  std::array<const SideTopology*, 2> sides_;
  const OverlayManner manner_;
  std::set<int> rim_;                              ///< vertices of the second side's creases
  std::array<std::map<int, Carrier>, 2> carriers_; ///< per vertex of a pair, on the other side
  std::set<std::pair<int, int>> crossed_;          ///< edges that have been looked at
  Meetings found_;
};

} // namespace

std::vector<std::array<std::vector<int>, 2>> Meetings::patches() const
{
  std::map<std::pair<std::size_t, int>, std::pair<std::size_t, int>> root; // of side and facet
  const auto find = [&root](std::pair<std::size_t, int> node) {
    for (auto next = root.find(node); next != root.end() && next->second != node; next = root.find(node))
      node = next->second;
    return node;
  };
  for (const auto& pair : pairs) {
    const auto first = find({0, pair[0]}), second = find({1, pair[1]});
    root.insert({first, first});
    root[second] = first;
  }
  std::map<std::pair<std::size_t, int>, std::array<std::vector<int>, 2>> byRoot;
  for (const std::size_t s : {0u, 1u})
    for (const int f : used[s])
      byRoot[find({s, f})][s].push_back(f);
  std::vector<std::array<std::vector<int>, 2>> result;
  for (auto& entry : byRoot)
    result.push_back(std::move(entry.second));
  return result;
}

std::vector<int> Meetings::wholeChain(std::size_t s, const SideTopology& side, int edge) const
{
  std::vector<int> chain{atVertex[s].at(side.ends(edge)[0])};
  if (const auto found = chains[s].find(edge); found != chains[s].end())
    chain.insert(chain.end(), found->second.begin(), found->second.end());
  chain.push_back(atVertex[s].at(side.ends(edge)[1]));
  return chain;
}

Meetings findMeetings(const SideTopology& first, const SideTopology& second, const OverlayManner& manner)
{
  return MeetingSearch(first, second, manner).run();
}

} // namespace ndframe
