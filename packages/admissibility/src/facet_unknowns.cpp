#include "facet_unknowns.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

FacetUnknowns::FacetUnknowns(const std::vector<ContactFacet>& facets, int order, TractionSign sign)
    : facets_(facets), order_(order), bernstein_(order == 2 && sign == TractionSign::Coefficients)
{
  NDFRAME_ASSERT(order == 1 || order == 2, "tractions of order 1 or 2");
  for (std::size_t f = 0; bernstein_ && f < facets.size(); ++f) {
    const auto middle = std::size_t(facets[f].nodes[2]);
    facetOfMiddle_.resize(std::max(facetOfMiddle_.size(), middle + 1), -1);
    facetOfMiddle_[middle] = int(f);
  }
}

void FacetUnknowns::fromNodal(Vector& values) const
{
  if (!bernstein_)
    return;
  for (const ContactFacet& facet : facets_) {
    double& middle = values[std::size_t(facet.nodes[2])];
    middle = 2.0 * middle - 0.5 * (values[std::size_t(facet.nodes[0])] + values[std::size_t(facet.nodes[1])]);
  }
}

void FacetUnknowns::toNodal(Vector& unknowns) const
{
  if (!bernstein_)
    return;
  for (const ContactFacet& facet : facets_) {
    double& middle = unknowns[std::size_t(facet.nodes[2])];
    middle = 0.5 * middle + 0.25 * (unknowns[std::size_t(facet.nodes[0])] + unknowns[std::size_t(facet.nodes[1])]);
  }
}

SparseRow FacetUnknowns::workFromNodal(const SparseRow& work, SparseSum& sum) const
{
  for (const auto& [node, value] : work) {
    const int facet = std::size_t(node) < facetOfMiddle_.size() ? facetOfMiddle_[std::size_t(node)] : -1;
    sum.add(node, facet < 0 ? value : 0.5 * value);
    for (std::size_t end = 0; facet >= 0 && end < 2; ++end)
      sum.add(facets_[std::size_t(facet)].nodes[end], 0.25 * value);
  }
  return sum.take();
}

double FacetUnknowns::mass(int i, int j) const
{
  static constexpr double linear[2][2] = {{1. / 3, 1. / 6}, {1. / 6, 1. / 3}};
  static constexpr double bernstein[3][3] = {
      {1. / 5, 1. / 30, 1. / 10}, {1. / 30, 1. / 5, 1. / 10}, {1. / 10, 1. / 10, 2. / 15}};
  static constexpr double nodal[3][3] = {
      {2. / 15, -1. / 30, 1. / 15}, {-1. / 30, 2. / 15, 1. / 15}, {1. / 15, 1. / 15, 8. / 15}};
  if (order_ == 1)
    return linear[i][j];
  return bernstein_ ? bernstein[i][j] : nodal[i][j];
}

} // namespace ndframe
