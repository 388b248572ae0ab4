#include "ndframe/interface/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "move_vertices.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/cutting/solid_sides.hpp"
#include "ndframe/mesh/bisection.hpp"

namespace ndframe
{
namespace
{

/// A facet may be so much longer than one that it faces.
constexpr double largestRatio = 2.0, leeway = 1e-6;
/// Halving ends: a cell's edge on the side is halved every second time at least.
constexpr int mostHalvings = 60;
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
    halveLongFacets();
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

  void replace(int body, DerivedMesh next)
  {
    DerivedMesh& result = results_[std::size_t(body)];
    result = result.parents.empty() ? std::move(next) : compose(result, std::move(next));
  }

  /// Per body and cell whether it has to be halved.
  std::vector<std::vector<int>> longCells()
  {
    std::vector<std::vector<int>> halvings;
    for (const DerivedMesh& result : results_)
      halvings.emplace_back(std::size_t(result.mesh.numCells()), 0);
    for (const FacingSides& sides : interfaces_)
      for (const FacingPiece& piece : pieces(sides)) {
        // seen along the segment, where facets that match are equally long
        const double one = 1.0 / std::abs(piece.onFirst[1] - piece.onFirst[0]),
                     other = 1.0 / std::abs(piece.onSecond[1] - piece.onSecond[0]);
        if (one > (largestRatio + leeway) * other)
          halvings[std::size_t(sides.firstBody)][std::size_t(piece.first.cell)] = 1;
        if (other > (largestRatio + leeway) * one)
          halvings[std::size_t(sides.secondBody)][std::size_t(piece.second.cell)] = 1;
      }
    return halvings;
  }

  void halveLongFacets()
  {
    for (int round = 0; round < mostHalvings; ++round) {
      const auto halvings = longCells();
      bool any = false;
      for (std::size_t b = 0; b < results_.size(); ++b) {
        if (std::none_of(halvings[b].begin(), halvings[b].end(), [](int n) { return n > 0; }))
          continue;
        any = true;
        Bisection bisection({results_[b].mesh}, {});
        bisection.refine({halvings[b]});
        replace(int(b), {bisection.meshes().front(), bisection.parents().front()});
      }
      if (!any)
        return;
    }
    throw InternalError("facets that face each other do not come to comparable lengths");
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
        replace(int(b), cutFacets(results_[b].mesh, cuts[b]));
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
