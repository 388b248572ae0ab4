#include "sampling_rules.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

constexpr int testDegree = 4;      ///< phi_a L_k of degree 1 + 3 is the highest that stars integrate
constexpr double offCorner = 1e-9; ///< of the way from a corner to the centroid

std::vector<double> cornerPoints(int dim)
{
  std::vector<double> points;
  for (int corner = 0; corner <= dim; ++corner)
    for (int k = 0; k <= dim; ++k)
      points.push_back((k == corner ? 1.0 - offCorner : 0.0) + offCorner / (dim + 1));
  return points;
}

/// Appends all Bernstein polynomials of degree `left` in lambda_k.. times `product`.
void appendBernstein(const double* lambda, int k, int dim, int left, double product, std::vector<double>& values)
{
  if (k == dim) {
    values.push_back(product * std::pow(lambda[dim], left));
    return;
  }
  for (int power = 0; power <= left; ++power) {
    appendBernstein(lambda, k + 1, dim, left - power, product, values);
    product *= lambda[k] * (left - power) / (power + 1); // binomial(left, power + 1) lambda^(power + 1)
  }
}

/// All Bernstein polynomials of a degree (columns) at points (rows).
DenseMatrix bernstein(const std::vector<double>& points, int dim, int degree)
{
  const int count = int(points.size()) / (dim + 1);
  std::vector<double> rows;
  for (int q = 0; q < count; ++q)
    appendBernstein(points.data() + q * (dim + 1), 0, dim, degree, 1.0, rows);
  const int size = int(rows.size()) / count;
  DenseMatrix values(count, size);
  for (int q = 0; q < count; ++q)
    for (int i = 0; i < size; ++i)
      values(q, i) = rows[std::size_t(q * size + i)];
  return values;
}

SamplingRule makeRule(int dim, int degree)
{
  SamplingRule result{simplexRule(dim, degree), cornerPoints(dim), {}};
  const int points = result.rule.size(), all = points + dim + 1;
  const int kept = std::min(degree / 2, degree - testDegree); // products with themselves are integrated exactly as well
  std::vector<double> everywhere = result.rule.lambda;
  everywhere.insert(everywhere.end(), result.corners.begin(), result.corners.end());
  const DenseMatrix V = bernstein(result.rule.lambda, dim, kept);
  DenseMatrix weighted = V;
  for (int q = 0; q < points; ++q)
    for (int i = 0; i < V.cols(); ++i)
      weighted(q, i) *= result.rule.weights[std::size_t(q)];
  const DenseCholesky mass(multiplyTransposed(V, weighted));
  DenseMatrix coefficients(V.cols(), points);
  for (int q = 0; q < points; ++q) {
    Vector row(std::size_t(V.cols()));
    for (int i = 0; i < V.cols(); ++i)
      row[std::size_t(i)] = weighted(q, i);
    row = mass.solve(std::move(row));
    std::copy(row.begin(), row.end(), coefficients.col(q));
  }
  const DenseMatrix projected = multiply(bernstein(everywhere, dim, kept), coefficients);
  result.rest = DenseMatrix(all, all);
  for (int i = 0; i < all; ++i) {
    result.rest(i, i) = 1.0;
    for (int q = 0; q < points; ++q)
      result.rest(i, q) -= projected(i, q);
  }
  return result;
}

template <int dim>
const SamplingLadder& ladderOf()
{
  static const SamplingLadder ladder = [] {
    SamplingLadder rules{makeRule(dim, 6), makeRule(dim, 8), makeRule(dim, 12)};
    if (dim < 3) // a thousand points in a tetrahedron, tested by a matrix of a million entries
      rules.push_back(makeRule(dim, 18));
    return rules;
  }();
  return ladder;
}

} // namespace

const SamplingLadder& samplingLadder(int dim)
{
  return dim == 1 ? ladderOf<1>() : dim == 2 ? ladderOf<2>() : ladderOf<3>();
}

} // namespace ndframe
