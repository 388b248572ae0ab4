#include "ndframe/mesh/cut_facets.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

using Triangle = std::array<int, 3>;
using Edge = std::array<int, 2>;

/// The part of a cell that has this edge, and the local number of the vertex opposite to it.
Facet findEdge(const std::vector<Triangle>& parts, const Edge& edge)
{
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (int apex = 0; apex < 3; ++apex) {
      const int a = parts[part][std::size_t((apex + 1) % 3)], b = parts[part][std::size_t((apex + 2) % 3)];
      if ((a == edge[0] && b == edge[1]) || (a == edge[1] && b == edge[0]))
        return {int(part), apex};
    }
  throw InternalError("a cut cell lost an edge");
}

/// Replaces one part by a fan around the vertex opposite to the edge a .. b, which has the points in between.
void fan(std::vector<Triangle>& parts, const std::vector<int>& chain)
{
  const Facet found = findEdge(parts, {chain.front(), chain.back()});
  const Triangle whole = parts[std::size_t(found.cell)];
  const int apex = whole[std::size_t(found.local)];
  const bool forward = whole[std::size_t((found.local + 1) % 3)] == chain.front();
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Triangle part = forward ? Triangle{apex, chain[i], chain[i + 1]} : Triangle{apex, chain[i + 1], chain[i]};
    if (i == 0)
      parts[std::size_t(found.cell)] = part;
    else
      parts.push_back(part);
  }
}

class Cutter
{
public:
  explicit Cutter(const Mesh& mesh) : old_(mesh), result_{mesh, std::vector<int>(std::size_t(mesh.numCells()))}
  {
    std::iota(result_.parents.begin(), result_.parents.end(), 0);
  }

  DerivedMesh run(const FacetCuts& cuts)
  {
    for (auto first = cuts.begin(); first != cuts.end();) {
      const int cell = first->first.first;
      std::vector<std::vector<int>> chains;
      for (; first != cuts.end() && first->first.first == cell; ++first)
        chains.push_back(chains_[first->first] = addPoints({cell, first->first.second}, first->second));
      cutCell(cell, chains);
    }
    for (std::size_t s = 0; s < old_.sides.size(); ++s)
      cutSide(old_.sides[s], result_.mesh.sides[s]);
    result_.mesh.groups.inherit(result_.parents);
    return std::move(result_);
  }

private:
  std::vector<int> addPoints(Facet facet, const std::vector<double>& places)
  {
    int ends[3];
    facetVertices(old_, facet, ends);
    std::vector<int> chain{ends[0]};
    for (const double t : places) {
      chain.push_back(result_.mesh.numPoints());
      for (int k = 0; k < 2; ++k)
        result_.mesh.points.push_back((1.0 - t) * old_.point(ends[0])[k] + t * old_.point(ends[1])[k]);
    }
    chain.push_back(ends[1]);
    return chain;
  }

  void cutCell(int cell, const std::vector<std::vector<int>>& chains)
  {
    const int* vertices = old_.cell(cell);
    std::vector<Triangle> parts{{vertices[0], vertices[1], vertices[2]}};
    for (const auto& chain : chains)
      fan(parts, chain);
    auto& numbers = partsOf_[cell];
    for (std::size_t part = 0; part < parts.size(); ++part) {
      numbers.push_back(part == 0 ? cell : result_.mesh.numCells());
      if (part == 0)
        std::copy(parts[0].begin(), parts[0].end(), result_.mesh.cells.begin() + std::ptrdiff_t(cell) * 3);
      else {
        result_.mesh.cells.insert(result_.mesh.cells.end(), parts[part].begin(), parts[part].end());
        result_.parents.push_back(cell);
      }
    }
    triangles_[cell] = std::move(parts);
  }

  /// The parts of a facet of a cell that was cut, along the facet itself or another one.
  void cutSide(const Side& old, Side& side) const
  {
    side.facets.clear();
    for (const Facet facet : old.facets) {
      const auto parts = triangles_.find(facet.cell);
      if (parts == triangles_.end()) {
        side.facets.push_back(facet);
        continue;
      }
      const auto known = chains_.find({facet.cell, facet.local});
      std::vector<int> chain(2);
      facetVertices(old_, facet, chain.data());
      if (known != chains_.end())
        chain = known->second;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const Facet found = findEdge(parts->second, {chain[i], chain[i + 1]});
        side.facets.push_back({partsOf_.at(facet.cell)[std::size_t(found.cell)], found.local});
      }
    }
  }

  const Mesh& old_;
  DerivedMesh result_;
  std::map<std::pair<int, int>, std::vector<int>> chains_; ///< vertices along a facet that is cut
  std::map<int, std::vector<Triangle>> triangles_;         ///< parts of a cell that is cut
  std::map<int, std::vector<int>> partsOf_;                ///< their numbers
};

} // namespace

DerivedMesh cutFacets(const Mesh& mesh, const FacetCuts& cuts)
{
  NDFRAME_ASSERT(mesh.dim == 2, "facets of triangles are cut");
  DerivedMesh result = Cutter(mesh).run(cuts);
  result.uncutPoints = mesh.numPoints();
  return result;
}

std::vector<int> ownNumbers(const Mesh& mesh)
{
  std::vector<int> numbers(std::size_t(mesh.numCells()));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

DerivedMesh compose(const DerivedMesh& first, DerivedMesh second)
{
  if (!first.parents.empty())
    for (int& parent : second.parents)
      parent = first.parents[std::size_t(parent)];
  return second;
}

} // namespace ndframe
