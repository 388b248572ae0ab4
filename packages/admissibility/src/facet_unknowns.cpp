#include "facet_unknowns.hpp"

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

FacetUnknowns::FacetUnknowns(const std::vector<ContactFacet>& facets, int order, TractionSign sign)
    : facets_(facets), order_(order), bernstein_(order == 2 && sign == TractionSign::Coefficients)
{
  NDFRAME_ASSERT(order == 1 || order == 2, "tractions of order 1 or 2");
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

void FacetUnknowns::workFromNodal(Vector& work) const
{
  if (!bernstein_)
    return;
  for (const ContactFacet& facet : facets_) {
    double& middle = work[std::size_t(facet.nodes[2])];
    for (const std::size_t end : {0, 1})
      work[std::size_t(facet.nodes[end])] += 0.25 * middle;
    middle *= 0.5;
  }
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
