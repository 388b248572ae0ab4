#include "mortar_functions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double nothing = 1e-14; ///< functions with smaller values at a node are zero there

/// The facets of a body's side before they were cut, each by its pieces. nodes: of the body, per interface node.
std::vector<std::vector<int>> uncutFacets(const InterfaceMesh& interface, const BodyModel& body,
                                          const std::vector<int>& nodes)
{
  std::vector<int> facetOf(std::size_t(interface.numFacets()));
  std::iota(facetOf.begin(), facetOf.end(), 0);
  std::map<int, int> pieceAt; // by the vertex that cut the facet
  for (int piece = 0; piece < interface.numFacets() && body.uncutPoints > 0; ++piece)
    for (int k = 0; k < 2; ++k) {
      const int node = interface.nodesOf(piece)[k];
      if (nodes[std::size_t(node)] < body.uncutPoints)
        continue;
      const auto [other, isNew] = pieceAt.insert({node, piece});
      if (!isNew)
        std::replace(facetOf.begin(), facetOf.end(), facetOf[std::size_t(piece)], facetOf[std::size_t(other->second)]);
    }
  std::map<int, std::vector<int>> pieces;
  for (std::size_t piece = 0; piece < facetOf.size(); ++piece)
    pieces[facetOf[piece]].push_back(int(piece));
  std::vector<std::vector<int>> facets;
  for (auto& entry : pieces)
    facets.push_back(std::move(entry.second));
  return facets;
}

} // namespace

MortarFunctions::MortarFunctions(const InterfaceMesh& interface, const std::vector<BodyModel>& bodies, bool isBernstein)
    : interface_(interface), isBernstein_(isBernstein), values_(std::size_t(interface.numNodes()))
{
  NDFRAME_ASSERT(interface.dim == 2, "only sides in the plane have mortar functions");
  std::array<std::vector<Pieces>, 2> facets;
  for (std::size_t k = 0; k < 2; ++k)
    facets[k] = uncutFacets(interface, bodies[std::size_t(interface.sides[k].body)], interface.sides[k].nodes);
  const std::size_t finer = facets[0].size() >= facets[1].size() ? 0 : 1;
  role_ = int(finer) == interface.dirichletSide ? ContactRole::Dirichlet : ContactRole::Neumann;
  for (const Pieces& facet : facets[finer])
    add(facet);
}

void MortarFunctions::add(const Pieces& facet)
{
  const Direction& normal = interface_.facetNormals[std::size_t(facet.front())];
  const Direction along{-normal[1], normal[0], 0.0};
  const auto [from, to] = ends(facet, along);
  const double start = placeOf(from, along), length = placeOf(to, along) - start;
  std::array<int, 3> number{numberAt(from), numberAt(to), -1};
  if (interface_.order == 2 && facet.size() == 1) {
    number[2] = numberAt(interface_.nodesOf(facet.front())[2]);
  } else if (interface_.order == 2) {
    number[2] = size();
    nodes_.push_back(-1);
  }
  differ_ = differ_ || facet.size() > 1;
  for (const int piece : facet)
    for (int k = 0; k < interface_.nodesPerFacet(); ++k)
      if (const int node = interface_.nodesOf(piece)[k]; node != from && node != to)
        values_[std::size_t(node)] = row(number, (placeOf(node, along) - start) / length);
  values_[std::size_t(from)] = {{number[0], 1.0}};
  values_[std::size_t(to)] = {{number[1], 1.0}};
}

/// The nodes at the ends of a facet, seen along a direction.
std::array<int, 2> MortarFunctions::ends(const Pieces& facet, const Direction& along) const
{
  std::vector<std::pair<double, int>> places;
  for (const int piece : facet)
    for (int k = 0; k < 2; ++k)
      places.emplace_back(placeOf(interface_.nodesOf(piece)[k], along), interface_.nodesOf(piece)[k]);
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  return {low->second, high->second};
}

/// The functions with these numbers at a place from 0 to 1 on their facet: those of both ends and of the middle.
SparseRow MortarFunctions::row(const std::array<int, 3>& number, double place) const
{
  const double s = place, r = 1.0 - place;
  std::array<double, 3> values{r, s, 0.0};
  if (interface_.order == 2)
    values = isBernstein_ ? std::array{r * r, s * s, 2.0 * r * s} : std::array{r * (r - s), s * (s - r), 4.0 * r * s};
  SparseRow result;
  for (std::size_t a = 0; a < 3; ++a)
    if (number[a] >= 0 && std::abs(values[a]) > nothing)
      result.emplace_back(number[a], values[a]);
  return result;
}

double MortarFunctions::placeOf(int node, const Direction& along) const
{
  const double* point = interface_.pointOf(role_, node);
  return point[0] * along[0] + point[1] * along[1];
}

int MortarFunctions::numberAt(int node)
{
  const auto [found, isNew] = atNode_.insert({node, size()});
  if (isNew)
    nodes_.push_back(node);
  return found->second;
}

} // namespace ndframe
