#include "side_topology.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ndframe
{
namespace
{

struct Box
{
  Vector3 lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Vector3& x, double margin)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = std::min(lower[k], x[k] - margin);
      upper[k] = std::max(upper[k], x[k] + margin);
    }
  }
  bool overlaps(const Box& other) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (upper[k] < other.lower[k] || other.upper[k] < lower[k])
        return false;
    return true;
  }
};

std::vector<Box> boxesOf(const SideTopology& side, double margin)
{
  std::vector<Box> boxes(std::size_t(side.numFacets()));
  for (int f = 0; f < side.numFacets(); ++f)
    for (const int vertex : side.vertices(f))
      boxes[std::size_t(f)].add(side.point(vertex), margin * side.sizeOfFacet(f));
  return boxes;
}

std::size_t longestAxis(const std::vector<Box>& boxes)
{
  Box all;
  for (const Box& box : boxes) {
    all.add(box.lower, 0.0);
    all.add(box.upper, 0.0);
  }
  Vector3 size{};
  for (std::size_t k = 0; k < 3; ++k)
    size[k] = all.upper[k] - all.lower[k];
  return std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
}

std::vector<int> sortedAlong(const std::vector<Box>& boxes, std::size_t axis)
{
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return boxes[std::size_t(a)].lower[axis] < boxes[std::size_t(b)].lower[axis]; });
  return order;
}

} // namespace

SideTopology::SideTopology(const Mesh& mesh, const std::vector<Facet>& facets) : mesh_(mesh), facets_(facets)
{
  std::map<std::array<int, 2>, int> edges;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    std::array<int, 3> v{}, own{};
    facetVertices(mesh, facets[f], v.data());
    Vector3 normal{};
    sizes_.push_back(std::sqrt(facetNormal(mesh, facets[f], normal.data())));
    normals_.push_back(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = v[(k + 1) % 3], b = v[(k + 2) % 3];
      const std::array<int, 2> ends{std::min(a, b), std::max(a, b)};
      const auto [found, isNew] = edges.insert({ends, int(ends_.size())});
      if (isNew) {
        ends_.push_back(ends);
        const Vector3 x = point(a), y = point(b);
        lengths_.push_back(std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
        ofEdge_.emplace_back();
      }
      own[k] = found->second;
      ofEdge_[std::size_t(own[k])].push_back(int(f));
      ofVertex_[v[k]].push_back(int(f));
      for (const int end : ends) {
        const auto [shortest, isFirst] = shortest_.insert({end, lengths_[std::size_t(own[k])]});
        shortest->second = std::min(shortest->second, lengths_[std::size_t(own[k])]);
      }
    }
    vertices_.push_back(v);
    edges_.push_back(own);
    ofFacet_.push_back({int(f)});
  }
}

Vector3 SideTopology::point(int vertex) const
{
  const double* x = mesh_.point(vertex);
  return {x[0], x[1], x[2]};
}

bool SideTopology::isInFacet(const Carrier& carrier, int f) const
{
  const auto has = [&](const std::array<int, 3>& all) {
    return std::find(all.begin(), all.end(), carrier.number) != all.end();
  };
  switch (carrier.kind) {
  case Carrier::Kind::Vertex:
    return has(vertices(f));
  case Carrier::Kind::Edge:
    return has(edges(f));
  case Carrier::Kind::Facet:
    return carrier.number == f;
  case Carrier::Kind::Nothing:
    break;
  }
  return false;
}

bool SideTopology::isInEdge(const Carrier& carrier, int edge) const
{
  if (carrier.kind == Carrier::Kind::Vertex)
    return carrier.number == ends(edge)[0] || carrier.number == ends(edge)[1];
  return carrier.kind == Carrier::Kind::Edge && carrier.number == edge;
}

const std::vector<int>& SideTopology::facetsOf(const Carrier& carrier) const
{
  static const std::vector<int> none;
  switch (carrier.kind) {
  case Carrier::Kind::Vertex:
    return ofVertex_.at(carrier.number);
  case Carrier::Kind::Edge:
    return ofEdge_[std::size_t(carrier.number)];
  case Carrier::Kind::Facet:
    return ofFacet_[std::size_t(carrier.number)];
  case Carrier::Kind::Nothing:
    break;
  }
  return none;
}

std::vector<std::array<int, 2>> nearFacets(const SideTopology& first, const SideTopology& second, double margin)
{
  const auto ours = boxesOf(first, margin), theirs = boxesOf(second, margin);
  const std::size_t axis = longestAxis(ours);
  const auto order = sortedAlong(ours, axis), others = sortedAlong(theirs, axis);
  std::vector<std::array<int, 2>> pairs;
  std::vector<int> active;
  std::size_t next = 0;
  for (const int f : order) {
    const Box& box = ours[std::size_t(f)];
    for (; next < others.size() && theirs[std::size_t(others[next])].lower[axis] <= box.upper[axis]; ++next)
      active.push_back(others[next]);
    active.erase(std::remove_if(active.begin(), active.end(),
                                [&](int g) { return theirs[std::size_t(g)].upper[axis] < box.lower[axis]; }),
                 active.end());
    for (const int g : active)
      if (box.overlaps(theirs[std::size_t(g)]))
        pairs.push_back({f, g});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace ndframe
