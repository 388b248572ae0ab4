#include "edge_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe
{
namespace
{

/// Halves a polynomial's Bernstein coefficients (de Casteljau): returns those of the left half and leaves the right.
Vector leftHalf(Vector& coefficients)
{
  Vector left;
  for (std::size_t last = coefficients.size(); last > 0; --last) {
    left.push_back(coefficients.front());
    for (std::size_t i = 0; i + 1 < last; ++i)
      coefficients[i] = 0.5 * (coefficients[i] + coefficients[i + 1]);
  }
  return left;
}

} // namespace

const EdgePieces::Table& EdgePieces::table(int points)
{
  const auto found = tables_.find(points);
  if (found != tables_.end())
    return found->second;
  return tables_.insert({points, {MomentBasis::polynomials(1, points - 1), bernsteinOfMoments(2, points - 1)}})
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
  constexpr int mostHalvings = 60;
  std::vector<Vector> parts{multiply(table(rule.size()).toBernstein, coefficients(rule, values))};
  const auto top = [](const Vector& part) { return *std::max_element(part.begin(), part.end()); };
  const auto isLower = [&](const Vector& a, const Vector& b) { return top(a) < top(b); };
  double attained = std::max(parts[0].front(), parts[0].back());
  for (int step = 0; step < mostHalvings && top(parts.front()) > attained; ++step) {
    std::pop_heap(parts.begin(), parts.end(), isLower);
    Vector right = parts.back();
    const Vector left = leftHalf(right);
    attained = std::max(attained, left.back());
    parts.back() = left;
    std::push_heap(parts.begin(), parts.end(), isLower);
    parts.push_back(std::move(right));
    std::push_heap(parts.begin(), parts.end(), isLower);
  }
  return top(parts.front());
}

std::array<double, 2> EdgePieces::endValues(const QuadratureRule& rule, const double* values)
{
  const Vector bernstein = multiply(table(rule.size()).toBernstein, coefficients(rule, values));
  return {bernstein.front(), bernstein.back()};
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
