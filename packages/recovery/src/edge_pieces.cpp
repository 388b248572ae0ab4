#include "edge_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/recovery/contact_traction.hpp"

namespace ndframe
{

const EdgePieces::Table& EdgePieces::table(int points)
{
  const auto found = tables_.find(points);
  if (found != tables_.end())
    return found->second;
  return tables_.insert({points, {MomentBasis::polynomials(1, points - 1), bernsteinOfMoments(points - 1)}})
      .first->second;
}

Vector EdgePieces::coefficients(const QuadratureRule& rule, const double* values)
{
  const MomentBasis& basis = table(rule.size()).basis;
  Vector all(std::size_t(rule.size()), 0.0), L(std::size_t(rule.size()));
  for (int q = 0; q < rule.size(); ++q) {
    basis.values(rule.point(q), L.data());
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] += rule.weights[std::size_t(q)] * values[q] * L[k];
  }
  return all;
}

double EdgePieces::upperBound(const QuadratureRule& rule, const double* values)
{
  const int points = rule.size();
  const Vector all = coefficients(rule, values);
  const Vector bernstein = multiply(table(points).toBernstein, all);
  // Legendre coefficients of a kink fall like k^(-3/2): what follows the last two is of the order of their number times
  // them, and an orthonormal polynomial reaches sqrt(2 k + 1).
  const double last = std::abs(all[std::size_t(points - 1)]) + std::abs(all[std::size_t(points - 2)]);
  return *std::max_element(bernstein.begin(), bernstein.end()) + points * std::sqrt(2.0 * points) * last;
}

Vector EdgePieces::derivatives(const Samples::Piece& piece, const double* values)
{
  const QuadratureRule& rule = *piece.rule;
  const auto [begin, end] = ends(piece);
  const Vector all = coefficients(rule, values);
  Vector slopes(all.size(), 0.0), dL(all.size());
  for (int q = 0; q < rule.size(); ++q) {
    table(rule.size()).basis.gradients(rule.point(q), dL.data());
    for (std::size_t k = 0; k < all.size(); ++k)
      slopes[std::size_t(q)] += all[k] * dL[k] / (end - begin);
  }
  return slopes;
}

} // namespace ndframe
