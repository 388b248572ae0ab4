#include "ndframe/mesh/long_facets.hpp"

#include <algorithm>

#include "ndframe/mesh/bisection.hpp"
#include "ndframe/mesh/tetrahedron_bisection.hpp"

namespace ndframe
{
namespace
{

/// A facet may be so much longer than the other one of a pair.
constexpr double largestRatio = 2.0, leeway = 1e-6;
constexpr int mostRounds = 60;

template <class Halving>
DerivedMesh halved(const Mesh& mesh, const std::vector<int>& halvings)
{
  Halving halving({mesh}, {});
  halving.refine({halvings});
  return {halving.meshes().front(), halving.parents().front()};
}

/// Per mesh and cell whether it has to be halved.
std::vector<std::vector<int>> longCells(const std::vector<DerivedMesh>& meshes, const std::vector<MeasuredPair>& pairs)
{
  std::vector<std::vector<int>> halvings;
  for (const DerivedMesh& mesh : meshes)
    halvings.emplace_back(std::size_t(mesh.mesh.numCells()), 0);
  for (const MeasuredPair& pair : pairs)
    for (const std::size_t k : {0u, 1u})
      if (pair[k].length > (largestRatio + leeway) * pair[1 - k].length)
        halvings[std::size_t(pair[k].mesh)][std::size_t(pair[k].facet.cell)] = 1;
  return halvings;
}

} // namespace

bool halveLongFacets(std::vector<DerivedMesh>& meshes, const std::function<std::vector<MeasuredPair>()>& pairs)
{
  for (int round = 0; round < mostRounds; ++round) {
    const auto halvings = longCells(meshes, pairs());
    bool any = false;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      if (std::none_of(halvings[m].begin(), halvings[m].end(), [](int n) { return n > 0; }))
        continue;
      any = true;
      const Mesh& mesh = meshes[m].mesh;
      meshes[m] = compose(meshes[m], mesh.dim == 2 ? halved<Bisection>(mesh, halvings[m])
                                                   : halved<TetrahedronBisection>(mesh, halvings[m]));
    }
    if (!any)
      return true;
  }
  return false;
}

} // namespace ndframe
