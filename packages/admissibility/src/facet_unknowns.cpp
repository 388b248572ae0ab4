#include "facet_unknowns.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

FacetUnknowns::FacetUnknowns(const std::vector<ContactPatch>& patches, int order, TractionSign sign)
    : dim_(dimOf(patches)), order_(order), bernstein_(order == 2 && sign == TractionSign::Coefficients)
{
  NDFRAME_ASSERT(order == 1 || order == 2, "tractions of order 1 or 2");
  NDFRAME_ASSERT(dim_ == 2 || order == 1 || bernstein_, "a vertex of a triangle carries no load in nodal values");
  const FacetEdges edges = facetEdges(dim_);
  for (std::size_t f = 0; bernstein_ && f < patches.size(); ++f)
    for (int e = 0; e < edges.size; ++e) {
      const auto node = std::size_t(patches[f].nodes[std::size_t(dim_) + std::size_t(e)]);
      middleOf_.resize(std::max(middleOf_.size(), node + 1), -1);
      if (middleOf_[node] >= 0)
        continue;
      middleOf_[node] = int(middles_.size());
      const auto [a, b] = edges.ends[e];
      middles_.push_back({int(node), {patches[f].nodes[std::size_t(a)], patches[f].nodes[std::size_t(b)]}});
    }
}

void FacetUnknowns::fromNodal(Vector& values) const
{
  for (const auto& [node, ends] : middles_) {
    double& middle = values[std::size_t(node)];
    middle = 2.0 * middle - 0.5 * (values[std::size_t(ends[0])] + values[std::size_t(ends[1])]);
  }
}

void FacetUnknowns::toNodal(Vector& unknowns) const
{
  for (const auto& [node, ends] : middles_) {
    double& middle = unknowns[std::size_t(node)];
    middle = 0.5 * middle + 0.25 * (unknowns[std::size_t(ends[0])] + unknowns[std::size_t(ends[1])]);
  }
}

SparseRow FacetUnknowns::workFromNodal(const SparseRow& work, SparseSum& sum) const
{
  for (const auto& [node, value] : work) {
    const int middle = std::size_t(node) < middleOf_.size() ? middleOf_[std::size_t(node)] : -1;
    sum.add(node, middle < 0 ? value : 0.5 * value);
    for (std::size_t end = 0; middle >= 0 && end < 2; ++end)
      sum.add(middles_[std::size_t(middle)].ends[end], 0.25 * value);
  }
  return sum.take();
}

/// Bernstein polynomials are lambda_a, or lambda_a^2 and 2 lambda_a lambda_b; with d = dim - 1 the mean of lambda^p is
/// d! p! / (d + |p|)!.
double FacetUnknowns::mass(int i, int j) const
{
  static constexpr double nodalOnEdges[3][3] = {
      {2. / 15, -1. / 30, 1. / 15}, {-1. / 30, 2. / 15, 1. / 15}, {1. / 15, 1. / 15, 8. / 15}};
  static constexpr double factorial[] = {1, 1, 2, 6, 24, 120, 720};
  if (order_ == 2 && !bernstein_)
    return nodalOnEdges[i][j];
  std::array<int, 3> power{};
  double product = factorial[dim_ - 1];
  for (const int k : {i, j})
    if (k < dim_)
      power[std::size_t(k)] += order_;
    else {
      product *= 2.0;
      for (const int end : facetEdges(dim_).ends[k - dim_])
        ++power[std::size_t(end)];
    }
  for (const int p : power)
    product *= factorial[p];
  return product / factorial[dim_ - 1 + 2 * order_];
}

} // namespace ndframe
