#include "piece_borders.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace ndframe
{
namespace
{

using Vertices = std::array<int, 3>; ///< of a facet, ascending; in two dimensions the last is none

Vertices verticesOf(const NodeMap& nodes, Facet facet)
{
  Vertices vertices;
  vertices.fill(std::numeric_limits<int>::max());
  for (int v = 0, next = 0; v <= nodes.dim; ++v)
    if (v != facet.local)
      vertices[std::size_t(next++)] = nodes.cell(facet.cell)[v];
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Per node whether a cell of the piece has it.
std::vector<char> nodesOf(const NodeMap& nodes, const std::vector<int>& owner, int piece)
{
  std::vector<char> has(std::size_t(nodes.numNodes()), 0);
  for (int cell = 0; cell < nodes.numCells(); ++cell)
    if (owner[std::size_t(cell)] == piece)
      for (int a = 0; a < nodes.nodesPerCell; ++a)
        has[std::size_t(nodes.cell(cell)[a])] = 1;
  return has;
}

/// The facets of the cells that `isWanted` names, if all their vertices are marked.
template <class Wanted, class Take>
void eachMarkedFacet(const NodeMap& nodes, const std::vector<char>& marked, Wanted isWanted, Take take)
{
  for (int cell = 0; cell < nodes.numCells(); ++cell)
    for (int local = 0; isWanted(cell) && local <= nodes.dim; ++local) {
      const Vertices vertices = verticesOf(nodes, {cell, local});
      if (std::all_of(vertices.begin(), vertices.begin() + nodes.dim, [&](int v) { return marked[std::size_t(v)]; }))
        take(vertices, Facet{cell, local});
    }
}

/// The facets that each other piece has, too.
std::map<int, std::map<Vertices, Facet>> sharedFacets(const NodeMap& nodes, const std::vector<int>& owner, int piece,
                                                      const std::vector<char>& shared)
{
  const auto isOwn = [&](int cell) { return owner[std::size_t(cell)] == piece; };
  std::map<Vertices, Facet> own;
  eachMarkedFacet(nodes, shared, isOwn, [&](const Vertices& v, Facet facet) { own.insert({v, facet}); });
  std::map<int, std::map<Vertices, Facet>> ofOther;
  eachMarkedFacet(
      nodes, shared, [&](int cell) { return !isOwn(cell); },
      [&](const Vertices& v, Facet facet) {
        if (const auto found = own.find(v); found != own.end())
          ofOther[owner[std::size_t(facet.cell)]].insert(*found);
      });
  return ofOther;
}

} // namespace

std::vector<PieceBorder> bordersOf(const NodeMap& nodes, const std::vector<int>& owner, int piece)
{
  const std::vector<char> own = nodesOf(nodes, owner, piece);
  std::vector<char> shared(own.size(), 0);
  std::map<int, std::set<int>> ofOther;
  for (int cell = 0; cell < nodes.numCells(); ++cell)
    for (int a = 0; owner[std::size_t(cell)] != piece && a < nodes.nodesPerCell; ++a)
      if (const int node = nodes.cell(cell)[a]; own[std::size_t(node)]) {
        shared[std::size_t(node)] = 1;
        ofOther[owner[std::size_t(cell)]].insert(node);
      }
  const auto facets = sharedFacets(nodes, owner, piece, shared);
  std::vector<PieceBorder> borders;
  for (const auto& [other, common] : ofOther) {
    borders.push_back({other, {common.begin(), common.end()}, {}});
    if (const auto found = facets.find(other); found != facets.end())
      for (const auto& [vertices, facet] : found->second)
        borders.back().facets.push_back(facet);
  }
  return borders;
}

} // namespace ndframe
