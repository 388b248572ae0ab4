#include "ndframe/interface/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "move_vertices.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/cutting/solid_sides.hpp"
#include "ndframe/mesh/long_facets.hpp"

namespace ndframe
{
namespace
{

/// Places on a facet nearer than this are its end, or one.
constexpr double sameCut = 1e-7;

class Insertion
{
public:
  Insertion(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces) : interfaces_(interfaces)
  {
    for (const Mesh& mesh : meshes)
      results_.push_back({mesh, {}});
  }

  std::vector<DerivedMesh> run()
  {
    if (!halveLongFacets(results_, [this] { return measuredPairs(); }))
      throw InternalError("facets that face each other do not come to comparable lengths");
    for (const FacingSides& sides : interfaces_)
      if (moveVertices(*sides.map, mesh(sides.firstBody), sides.firstSide, mesh(sides.secondBody), sides.secondSide,
                       pieces(sides)))
        for (const int body : {sides.firstBody, sides.secondBody})
          if (results_[std::size_t(body)].parents.empty())
            results_[std::size_t(body)].parents = ownNumbers(mesh(body));
    cut();
    return std::move(results_);
  }

private:
  Mesh& mesh(int body) { return results_[std::size_t(body)].mesh; }

  std::vector<FacingPiece> pieces(const FacingSides& sides)
  {
    Mesh &first = mesh(sides.firstBody), &second = mesh(sides.secondBody);
    return facingPieces(*sides.map, first, first.findSide(sides.firstSide)->facets, second,
                        second.findSide(sides.secondSide)->facets);
  }

  std::vector<MeasuredPair> measuredPairs()
  {
    std::vector<MeasuredPair> pairs;
    for (const FacingSides& sides : interfaces_)
      for (const FacingPiece& piece : pieces(sides)) {
        // seen along the segment, where facets that match are equally long
        const double one = 1.0 / std::abs(piece.onFirst[1] - piece.onFirst[0]),
                     other = 1.0 / std::abs(piece.onSecond[1] - piece.onSecond[0]);
        pairs.push_back({{{sides.firstBody, piece.first, one}, {sides.secondBody, piece.second, other}}});
      }
    return pairs;
  }

  void cut()
  {
    std::vector<FacetCuts> cuts(results_.size());
    const auto add = [&](int body, Facet facet, double place) {
      if (place > sameCut && place < 1.0 - sameCut)
        cuts[std::size_t(body)][{facet.cell, facet.local}].push_back(place);
    };
    for (const FacingSides& sides : interfaces_)
      for (const FacingPiece& piece : pieces(sides))
        for (const std::size_t end : {0u, 1u}) {
          add(sides.firstBody, piece.first, piece.onFirst[end]);
          add(sides.secondBody, piece.second, piece.onSecond[end]);
        }
    for (std::size_t b = 0; b < cuts.size(); ++b) {
      for (auto& [facet, places] : cuts[b]) {
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end(), [](double x, double y) { return y - x < sameCut; }),
                     places.end());
      }
      if (!cuts[b].empty())
        results_[b] = compose(results_[b], cutFacets(results_[b].mesh, cuts[b]));
    }
  }

  const std::vector<FacingSides>& interfaces_;
  std::vector<DerivedMesh> results_;
};

} // namespace

std::vector<DerivedMesh> insertion(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces)
{
  const bool isSpace = !interfaces.empty() && meshes[std::size_t(interfaces.front().firstBody)].dim == 3;
  if (!isSpace)
    return Insertion(meshes, interfaces).run();
  std::vector<SolidSides> solids;
  for (const FacingSides& sides : interfaces)
    solids.push_back({sides.firstBody, sides.secondBody, sides.firstSide, sides.secondSide, sides.isCut});
  return cutSolids(meshes, solids);
}

} // namespace ndframe
