#pragma once

#include <cmath>

#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// The mean value of f lambda_a^power by the samples.
inline double mean(const Samples& samples, int a, int power)
{
  double sum = 0.0;
  for (int q = 0; q < samples.rule.size(); ++q)
    sum += samples.rule.weights[std::size_t(q)] * samples.values[std::size_t(q)] *
           std::pow(samples.rule.point(q)[a], power);
  return sum;
}

/// Of a function at a point of a simplex, by the vertices of the simplex and barycentric coordinates.
inline double valueAt(const ExpressionTree& tree, const DataSampler::Vertices& vertices, int dim, int space,
                      const double* lambda)
{
  double point[3] = {}, value = 0.0;
  for (std::size_t v = 0; v <= std::size_t(dim); ++v)
    for (std::size_t k = 0; k < std::size_t(space); ++k)
      point[k] += lambda[v] * vertices[v][k];
  tree.values(point, 1, &value);
  return value;
}

/// int x^n y^m over the unit simplex times dim!.
inline double meanOfMonomial(int dim, int n, int m)
{
  return std::tgamma(n + 1.0) * std::tgamma(m + 1.0) * std::tgamma(dim + 1.0) / std::tgamma(n + m + dim + 1.0);
}

} // namespace ndframe
