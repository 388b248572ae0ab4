#pragma once

#include <vector>

#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// Numbers at the points of a rule as rows that are padded with zeros to a multiple of four, so that sums over the
/// points are taken four at a time.
std::size_t paddedCount(int points);

/// Samples of `size` components as one row a component. Memory of `rows` is reused.
void rowsOf(const Samples& samples, int size, std::vector<double>& rows);

/// sums[k size + i] = factor sum_g table[g][k] values[g size + i] for k < count (28 at most), g < points and `size`
/// components; the rows of the table are padded.
void sumOverPoints(const double* table, int points, int count, double factor, const double* values, std::size_t size,
                   double* sums);

/// sum_i sum_g weights[g] (values[i][g] - sum_k factors[k size + i] table[k][g])^2: the mean square of what is left of
/// components when `count` functions are taken off.
double squareOfRest(const double* table, std::size_t count, std::size_t stride, const double* factors,
                    const double* values, std::size_t size, const double* weights);

} // namespace ndframe
