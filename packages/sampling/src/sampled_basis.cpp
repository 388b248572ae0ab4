#include "ndframe/sampling/sampled_basis.hpp"

#include "ndframe/sampling/point_sums.hpp"

namespace ndframe
{

BasisTables SampledBasis::make(const QuadratureRule& rule, const std::array<int, 4>& places) const
{
  const std::size_t vertices = std::size_t(rule.dim) + 1, points = std::size_t(rule.size());
  const std::size_t modes = std::size_t(size()), row = paddedCount(size()), stride = paddedCount(rule.size());
  BasisTables tables{std::vector<double>(points * row), std::vector<double>(modes * stride),
                     std::vector<double>(stride)};
  std::vector<double> lambda(vertices), at(modes);
  std::copy(rule.weights.begin(), rule.weights.end(), tables.weights.begin());
  for (std::size_t g = 0; g < points; ++g) {
    for (std::size_t v = 0; v < vertices; ++v)
      lambda[std::size_t(places[v])] = rule.point(int(g))[v];
    basis_.values(lambda.data(), at.data());
    for (std::size_t k = 0; k < modes; ++k) {
      tables.values[k * stride + g] = at[k];
      tables.weighted[g * row + k] = rule.weights[g] * at[k];
    }
  }
  return tables;
}

const BasisTables& SampledBasis::at(const Samples& samples, const std::array<int, 4>& places)
{
  if (samples.pieces.size() != 1 || samples.pieces.front().rule == nullptr)
    return many_ = make(samples.rule, places);
  auto& known = known_[{samples.pieces.front().rule, places}];
  if (known.values.empty())
    known = make(samples.rule, places);
  return known;
}

} // namespace ndframe
