#pragma once

#include <vector>

#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/sampling/point_sums.hpp"

namespace ndframe
{

/// int q . v for the Lagrange functions on simplices. Their values times the rule's weights are kept for the next
/// simplex where samples are constant or of one piece that names its rule.
template <int simplexDim, int order>
class NodalForces
{
public:
  static constexpr int count = Lagrange<simplexDim, order>::nodes;

  /// forces: count * dim, node by node.
  void find(const LoadedSimplex& simplex, int dim, double* forces)
  {
    const Samples& samples = simplex.samples;
    const QuadratureRule* rule = samples.pieces.size() == 1 ? samples.pieces.front().rule : nullptr;
    const bool isKnown = samples.pieces.empty() ? !table_.empty() : rule != nullptr && rule == rule_;
    if (!isKnown)
      tabulate(samples.rule);
    rule_ = rule;
    sumOverPoints(table_.data(), samples.rule.size(), count, simplex.measure, samples.values.data(), std::size_t(dim),
                  forces);
  }

private:
  void tabulate(const QuadratureRule& rule)
  {
    const std::size_t row = paddedCount(count);
    table_.assign(std::size_t(rule.size()) * row, 0.0);
    double N[count];
    for (int g = 0; g < rule.size(); ++g) {
      Lagrange<simplexDim, order>::values(rule.point(g), N);
      for (std::size_t a = 0; a < std::size_t(count); ++a)
        table_[std::size_t(g) * row + a] = rule.weights[std::size_t(g)] * N[a];
    }
  }

  const QuadratureRule* rule_ = nullptr;
  std::vector<double> table_; ///< weight N_a, a row a point, padded
};

} // namespace ndframe
