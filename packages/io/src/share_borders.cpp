#include <algorithm>
#include <array>
#include <map>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/ascending.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/io/piece_border.hpp"

namespace ndframe
{
namespace
{

using Number = std::int64_t;
using Numbers = std::vector<Number>;
using OfRanks = std::vector<Numbers>;        ///< per process
using Vertices = std::array<Number, 3>;      ///< of a facet, ascending; in two dimensions the last is none
using OwnFacets = std::map<Vertices, Facet>; ///< in the order of their vertices

constexpr Number none = -1;

/// Per node of the share, whether the piece has it.
std::vector<char> nodesOfPiece(const SharedNodes& share)
{
  std::vector<char> has(share.numbers.size(), 0);
  for (int cell = 0; cell < share.numOwnCells; ++cell)
    for (int a = 0; a < share.nodes.nodesPerCell; ++a)
      has[std::size_t(share.nodes.cell(cell)[a])] = 1;
  return has;
}

/// Nodes that several pieces have, told by their owners: per process one after the other the node, how many have it,
/// and which.
OfRanks holdersOfOwn(const OfRanks& told, const Numbers& own, int rank)
{
  std::map<Number, std::vector<int>> holders;
  for (std::size_t other = 0; other < told.size(); ++other)
    for (const Number node : told[other])
      holders[node].push_back(int(other));
  OfRanks messages(told.size());
  for (auto& [node, ranks] : holders) {
    if (std::binary_search(own.begin(), own.end(), node))
      ranks.insert(std::lower_bound(ranks.begin(), ranks.end(), rank), rank);
    for (const int to : ranks) {
      if (ranks.size() == 1)
        continue;
      Numbers& message = messages[std::size_t(to)];
      message.insert(message.end(), {node, Number(ranks.size())});
      message.insert(message.end(), ranks.begin(), ranks.end());
    }
  }
  return messages;
}

/// Per other piece the numbers of common nodes, ascending.
std::map<int, Numbers> commonNodes(const SharedNodes& share, const Comm& comm)
{
  const std::vector<char> has = nodesOfPiece(share);
  OfRanks others(std::size_t(comm.size()));
  Numbers own;
  for (std::size_t node = 0; node < has.size(); ++node)
    if (has[node] != 0)
      (share.owners[node] == comm.rank() ? own : others[std::size_t(share.owners[node])])
          .push_back(share.numbers[node]);
  std::map<int, Numbers> common;
  for (const Numbers& message : askedFor(holdersOfOwn(askedFor(others, comm), own, comm.rank()), comm))
    for (std::size_t at = 0; at < message.size(); at += 2 + std::size_t(message[at + 1]))
      for (Number i = 0; i < message[at + 1]; ++i)
        if (const int holder = int(message[at + 2 + std::size_t(i)]); holder != comm.rank())
          common[holder].push_back(message[at]);
  for (auto& [other, nodes] : common)
    std::sort(nodes.begin(), nodes.end());
  return common;
}

Vertices verticesOf(const SharedNodes& share, Facet facet)
{
  Vertices vertices{none, none, none};
  for (int v = 0, next = 0; v <= share.nodes.dim; ++v)
    if (v != facet.local)
      vertices[std::size_t(next++)] = share.numbers[std::size_t(share.nodes.cell(facet.cell)[v])];
  std::sort(vertices.begin(), vertices.begin() + share.nodes.dim);
  return vertices;
}

/// Facets of the piece whose vertices any other piece has.
OwnFacets borderFacets(const SharedNodes& share, const std::map<int, Numbers>& common)
{
  Numbers all;
  for (const auto& [other, nodes] : common)
    all.insert(all.end(), nodes.begin(), nodes.end());
  std::sort(all.begin(), all.end());
  std::vector<char> isCommon(share.numbers.size(), 0);
  for (std::size_t node = 0; node < isCommon.size(); ++node)
    isCommon[node] = char(std::binary_search(all.begin(), all.end(), share.numbers[node]));
  OwnFacets facets;
  for (int cell = 0; cell < share.numOwnCells; ++cell) {
    const int* const nodes = share.nodes.cell(cell);
    for (int local = 0; local <= share.nodes.dim; ++local) {
      bool isBorder = true;
      for (int v = 0; v <= share.nodes.dim; ++v)
        isBorder = isBorder && (v == local || isCommon[std::size_t(nodes[v])] != 0);
      if (isBorder)
        facets.insert({verticesOf(share, {cell, local}), {cell, local}});
    }
  }
  return facets;
}

/// Per process the facets that may be common, by their vertices: those with all vertices in common.
OfRanks offered(const OwnFacets& facets, const std::map<int, Numbers>& common, int dim, int ranks)
{
  OfRanks offers(static_cast<std::size_t>(ranks));
  for (const auto& [other, nodes] : common)
    for (const auto& [vertices, facet] : facets)
      if (std::all_of(vertices.begin(), vertices.begin() + dim,
                      [&nodes = nodes](Number v) { return std::binary_search(nodes.begin(), nodes.end(), v); }))
        offers[std::size_t(other)].insert(offers[std::size_t(other)].end(), vertices.begin(), vertices.end());
  return offers;
}

} // namespace

std::vector<PieceBorder> bordersOfShare(const SharedNodes& share, const Comm& comm)
{
  const std::map<int, Numbers> common = commonNodes(share, comm);
  const OwnFacets facets = borderFacets(share, common);
  const OfRanks theirs = askedFor(offered(facets, common, share.nodes.dim, comm.size()), comm);
  std::vector<PieceBorder> borders;
  for (const auto& [other, nodes] : common) {
    borders.push_back({other, {}, {}});
    for (const Number node : nodes) {
      borders.back().nodes.push_back(placeOf(share.numbers, node));
      NDFRAME_ASSERT(borders.back().nodes.back() >= 0, "a piece's nodes are in its share");
    }
    const Numbers& offer = theirs[std::size_t(other)];
    for (std::size_t at = 0; at < offer.size(); at += 3) // in the order of their vertices
      if (const auto found = facets.find({offer[at], offer[at + 1], offer[at + 2]}); found != facets.end())
        borders.back().facets.push_back(found->second);
  }
  return borders;
}

} // namespace ndframe
