#include "ndframe/cutting/solid_sides.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "flat_overlay.hpp"
#include "flat_pairs.hpp"
#include "loose_flat_vertices.hpp"
#include "ndframe/cutting/cannot_cut.hpp"
#include "ndframe/mesh/long_facets.hpp"

namespace ndframe
{
namespace
{

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
    if (!halveLongFacets(results_, [this] { return measuredPairs(); }))
      throw CannotCut("facets that lie on each other do not come to comparable lengths");
    for (const SolidSides& sides : interfaces_)
      if (sides.isCut && sides.firstBody != sides.secondBody) {
        move(sides, moveFlatVertices);
      }
    for (int round = 0; cutOnce(); ++round)
      if (round == mostRounds)
        throw CannotCut("sides that share edges do not come to the same vertices");
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

  const std::vector<Facet>& facets(int body, const std::string& side) { return mesh(body).findSide(side)->facets; }

  std::vector<MeasuredPair> measuredPairs()
  {
    const auto measured = [](int body, const SideTopology& side, int f) -> MeasuredFacet {
      const auto& edges = side.edges(f);
      return {body, side.facet(f), std::max({side.length(edges[0]), side.length(edges[1]), side.length(edges[2])})};
    };
    std::vector<MeasuredPair> pairs;
    for (const SolidSides& sides : interfaces_) {
      const SideTopology first(mesh(sides.firstBody), facets(sides.firstBody, sides.firstSide)),
          second(mesh(sides.secondBody), facets(sides.secondBody, sides.secondSide));
      for (const auto& pair : overlappingFacets(first, second))
        pairs.push_back(
            {measured(sides.firstBody, first, pair.first), measured(sides.secondBody, second, pair.second)});
    }
    return pairs;
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
    } catch (const CannotCut&) {
      if (&manner == &manners.back())
        throw;
      return std::nullopt;
    }
    for (auto& [body, next] : made) {
      DerivedMesh& result = results_[std::size_t(body)];
      result = compose(result, std::move(next));
    }
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
    } catch (const CannotCut&) { // as in tryToCut()
    }
  return false;
}

} // namespace ndframe
