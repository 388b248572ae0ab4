#include "ndframe/cutting/solid_sides.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "flat_overlay.hpp"
#include "flat_pairs.hpp"
#include "loose_flat_vertices.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/tetrahedron_bisection.hpp"

namespace ndframe
{
namespace
{

/// A facet may be so much longer than one that it lies on.
constexpr double largestRatio = 2.0, leeway = 1e-6;
constexpr int mostHalvings = 60;
/// How near vertices edges are led through them, relative to the edges there, and whether points are moved: the first
/// that is possible.
constexpr std::array<OverlayManner, 4> manners{{{0.2, true}, {0.2, false}, {0.05, false}, {1e-6, false}}};
/// Sides that share edges hand points on to each other.
constexpr int mostRounds = 20;

class SolidInsertion
{
public:
  SolidInsertion(const std::vector<Mesh>& meshes, const std::vector<SolidSides>& interfaces) : interfaces_(interfaces)
  {
    for (const Mesh& mesh : meshes)
      results_.push_back({mesh, {}});
  }

  std::vector<DerivedMesh> run()
  {
    halveLongFacets();
    for (const SolidSides& sides : interfaces_)
      if (sides.isCut && sides.firstBody != sides.secondBody) {
        move(sides, moveFlatVertices);
      }
    for (int round = 0; cutOnce(); ++round)
      if (round == mostRounds)
        throw InternalError("sides that share edges do not come to the same vertices");
    return std::move(results_);
  }

private:
  Mesh& mesh(int body) { return results_[std::size_t(body)].mesh; }

  static void keepNumbers(DerivedMesh& result)
  {
    if (result.parents.empty())
      result.parents = ownNumbers(result.mesh);
  }

  template <class Mover>
  void move(const SolidSides& sides, const Mover& mover)
  {
    const auto moved = mover(mesh(sides.firstBody), sides.firstSide, mesh(sides.secondBody), sides.secondSide);
    if (moved[0])
      keepNumbers(results_[std::size_t(sides.firstBody)]);
    if (moved[1])
      keepNumbers(results_[std::size_t(sides.secondBody)]);
  }

  void replace(int body, DerivedMesh next)
  {
    DerivedMesh& result = results_[std::size_t(body)];
    result = result.parents.empty() ? std::move(next) : compose(result, std::move(next));
  }

  const std::vector<Facet>& facets(int body, const std::string& side) { return mesh(body).findSide(side)->facets; }

  std::vector<std::vector<int>> longCells()
  {
    std::vector<std::vector<int>> halvings;
    for (const DerivedMesh& result : results_)
      halvings.emplace_back(std::size_t(result.mesh.numCells()), 0);
    for (const SolidSides& sides : interfaces_) {
      const SideTopology first(mesh(sides.firstBody), facets(sides.firstBody, sides.firstSide)),
          second(mesh(sides.secondBody), facets(sides.secondBody, sides.secondSide));
      const auto longest = [](const SideTopology& side, int f) {
        const auto& edges = side.edges(f);
        return std::max({side.length(edges[0]), side.length(edges[1]), side.length(edges[2])});
      };
      for (const auto& pair : overlappingFacets(first, second)) {
        const double one = longest(first, pair.first), other = longest(second, pair.second);
        if (one > (largestRatio + leeway) * other)
          halvings[std::size_t(sides.firstBody)][std::size_t(first.facet(pair.first).cell)] = 1;
        if (other > (largestRatio + leeway) * one)
          halvings[std::size_t(sides.secondBody)][std::size_t(second.facet(pair.second).cell)] = 1;
      }
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
        TetrahedronBisection bisection({results_[b].mesh}, {});
        bisection.refine({halvings[b]});
        replace(int(b), {bisection.meshes().front(), bisection.parents().front()});
      }
      if (!any)
        return;
    }
    throw InternalError("facets that lie on each other do not come to comparable lengths");
  }

  /// False when all sides have the same vertices where they lie on each other.
  bool cutOnce()
  {
    bool any = false;
    for (const SolidSides& sides : interfaces_)
      for (const OverlayManner& manner : manners) {
        const auto cut = tryToCut(sides, manner);
        if (!cut)
          continue;
        any = any || *cut;
        break;
      }
    return any;
  }

  /// Whether anything was cut; nothing if edges would cross or cells turn over.
  std::optional<bool> tryToCut(const SolidSides& sides, const OverlayManner& manner)
  {
    const bool isOne = sides.firstBody == sides.secondBody;
    FacetSplits ours, theirs;
    std::vector<std::pair<int, DerivedMesh>> made;
    try {
      overlay(mesh(sides.firstBody), facets(sides.firstBody, sides.firstSide), ours, mesh(sides.secondBody),
              facets(sides.secondBody, sides.secondSide), isOne ? ours : theirs, manner);
      for (const auto& [body, splits] : {std::pair(sides.firstBody, &ours), std::pair(sides.secondBody, &theirs)})
        if (!splits->empty())
          made.emplace_back(body, splitFacets(mesh(body), *splits));
    } catch (const InternalError&) {
      if (&manner == &manners.back())
        throw;
      return std::nullopt;
    }
    for (auto& [body, next] : made)
      replace(body, std::move(next));
    return !made.empty();
  }

  const std::vector<SolidSides>& interfaces_;
  std::vector<DerivedMesh> results_;
};

} // namespace

std::vector<DerivedMesh> cutSolids(const std::vector<Mesh>& meshes, const std::vector<SolidSides>& interfaces)
{
  return SolidInsertion(meshes, interfaces).run();
}

bool cutAtRims(Mesh& mesh, const std::string& side, const Mesh& other, const std::string& otherSide)
{
  for (OverlayManner manner : manners)
    try {
      manner.ofRims = true;
      FacetSplits splits, unused;
      overlay(mesh, mesh.findSide(side)->facets, splits, other, other.findSide(otherSide)->facets, unused, manner);
      if (splits.empty())
        return false;
      mesh = splitFacets(mesh, splits).mesh;
      return true;
    } catch (const InternalError&) { // as in tryToCut()
    }
  return false;
}

} // namespace ndframe
