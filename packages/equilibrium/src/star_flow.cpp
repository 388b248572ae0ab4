#include "ndframe/equilibrium/star_flow.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

void addScaled(DenseMatrix& A, double factor, const DenseMatrix& B)
{
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i)
      A(i, j) += factor * B(i, j);
}

} // namespace

std::vector<DenseMatrix> carryAlongTree(const Star& star, const SpanningTree& tree, std::vector<DenseMatrix>& needed)
{
  std::vector<DenseMatrix> flows(star.spokes.size(), DenseMatrix(needed[0].rows(), 0));
  for (std::size_t i = tree.order.size() - 1; i > 0; --i) {
    const int cell = tree.order[i];
    const std::size_t s = std::size_t(tree.parent[std::size_t(cell)]);
    const Spoke& spoke = star.spokes[s];
    DenseMatrix& carried = needed[std::size_t(cell)];
    const bool isFirst = spoke.cell[0] == cell;
    // The other side of the spoke gets the opposite wrench, so the parent needs that much more elsewhere.
    addScaled(needed[std::size_t(spoke.cell[isFirst ? 1 : 0])], 1.0, carried);
    flows[s] = DenseMatrix(carried.rows(), carried.cols());
    addScaled(flows[s], isFirst ? 1.0 : -1.0, carried);
    carried = DenseMatrix(carried.rows(), carried.cols());
  }
  return flows;
}

std::vector<GroundTraction> reactions(const StarBody& body, const Star& star)
{
  std::vector<GroundTraction> list;
  for (int s = 0; s < int(star.spokes.size()); ++s) {
    const Spoke& spoke = star.spokes[std::size_t(s)];
    if (!spoke.onBoundary())
      continue;
    const int index = body.boundaryIndex(star.cells[std::size_t(spoke.cell[0])].cell, spoke.facet[0]);
    if (index < 0)
      continue;
    const BoundaryFacet& facet = body.data().boundary[std::size_t(index)];
    for (int mode = 0; mode < body.facetModes(); ++mode)
      for (int d = 0; d < facet.supported; ++d)
        list.push_back({s, mode, facet.directions[std::size_t(d)]});
  }
  return list;
}

std::vector<GroundTraction> releasedTractions(const StarBody& body, const Star& star,
                                              const std::vector<ReleasedFacet>& released)
{
  std::vector<GroundTraction> list;
  for (const ReleasedFacet& facet : released) {
    const int sorted = sortedFacet(body.model().mesh, facet.facet);
    const auto spoke = std::find_if(star.spokes.begin(), star.spokes.end(), [&](const Spoke& candidate) {
      return star.cells[std::size_t(candidate.cell[0])].cell == facet.facet.cell && candidate.facet[0] == sorted;
    });
    NDFRAME_ASSERT(spoke != star.spokes.end() && spoke->onBoundary(), "a released facet is not a boundary of the star");
    for (int mode = 0; mode < body.facetModes(); ++mode)
      list.push_back({int(spoke - star.spokes.begin()), mode, facet.direction});
  }
  return list;
}

} // namespace ndframe
