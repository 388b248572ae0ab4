#include "triangle_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr int highestDegree = 9;

/// Whether the rule integrates all products of the polynomials of a degree.
bool integratesSquares(const QuadratureRule& rule, int degree)
{
  constexpr double roundOff = 1e-12;
  const MomentBasis basis = MomentBasis::polynomials(2, degree);
  DenseMatrix gram(basis.size(), basis.size());
  Vector L(std::size_t(basis.size()));
  for (int q = 0; q < rule.size(); ++q) {
    basis.values(rule.point(q), L.data());
    for (int i = 0; i < gram.rows(); ++i)
      for (int j = 0; j < gram.cols(); ++j)
        gram(i, j) += rule.weights[std::size_t(q)] * L[std::size_t(i)] * L[std::size_t(j)];
  }
  for (int i = 0; i < gram.rows(); ++i)
    for (int j = 0; j < gram.cols(); ++j)
      if (std::abs(gram(i, j) - (i == j ? 1.0 : 0.0)) > roundOff)
        return false;
  return true;
}

int degreeOf(const QuadratureRule& rule)
{
  int degree = highestDegree;
  while (degree > 0 && !integratesSquares(rule, degree))
    --degree;
  return degree;
}

/// Two halves, across the longest edge in barycentric coordinates.
std::array<std::array<std::array<double, 3>, 3>, 2> halves(const std::array<std::array<double, 3>, 3>& corners)
{
  std::size_t apex = 0;
  double longest = -1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto &b = corners[(a + 1) % 3], &c = corners[(a + 2) % 3];
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      length += (b[i] - c[i]) * (b[i] - c[i]);
    if (length > longest)
      longest = length, apex = a;
  }
  const auto &b = corners[(apex + 1) % 3], &c = corners[(apex + 2) % 3];
  std::array<double, 3> middle{};
  for (std::size_t i = 0; i < 3; ++i)
    middle[i] = 0.5 * (b[i] + c[i]);
  return {{{corners[apex], b, middle}, {corners[apex], middle, c}}};
}

} // namespace

double TrianglePieces::Part::top() const
{
  return *std::max_element(bernstein.begin(), bernstein.end());
}

const TrianglePieces::Table& TrianglePieces::table(const QuadratureRule& rule)
{
  const auto found = tables_.find(rule.size());
  if (found != tables_.end())
    return found->second;
  const int degree = degreeOf(rule);
  Table table{MomentBasis::polynomials(2, degree), {}, {}, {}};
  for (int i = degree; i >= 0; --i)
    for (int j = degree - i; j >= 0; --j) {
      const std::array<double, 3> powers{double(i), double(j), double(degree - i - j)};
      for (std::size_t a = 0; a < 3; ++a)
        if (powers[a] == degree)
          table.vertices[a] = table.lattice.size();
      const double scale = std::max(degree, 1);
      table.lattice.push_back(degree == 0 ? std::array{1. / 3, 1. / 3, 1. / 3}
                                          : std::array{powers[0] / scale, powers[1] / scale, powers[2] / scale});
    }
  const int size = table.basis.size();
  DenseMatrix values(size, size);
  Vector L(std::size_t(size), 0.0);
  for (int p = 0; p < size; ++p) {
    table.basis.values(table.lattice[std::size_t(p)].data(), L.data());
    for (int k = 0; k < size; ++k)
      values(p, k) = L[std::size_t(k)];
  }
  table.toBernstein = multiply(bernsteinOfMoments(3, degree), pseudoInverse(values, 1e-12));
  return tables_.insert({rule.size(), std::move(table)}).first->second;
}

TrianglePieces::Part TrianglePieces::part(const Table& table, const Vector& coefficients, const Corners& corners) const
{
  Vector values, L(coefficients.size());
  for (const auto& point : table.lattice) {
    std::array<double, 3> lambda{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t i = 0; i < 3; ++i)
        lambda[i] += point[a] * corners[a][i];
    table.basis.values(lambda.data(), L.data());
    values.push_back(dot(coefficients, L));
  }
  return {corners, multiply(table.toBernstein, values)};
}

double TrianglePieces::upperBound(const QuadratureRule& rule, const double* values)
{
  constexpr int mostHalvings = 100;
  constexpr double closeEnough = 1e-3; // of the range that is left
  const Table& known = table(rule);
  Vector coefficients(std::size_t(known.basis.size()), 0.0), L(coefficients.size());
  for (int q = 0; q < rule.size(); ++q) {
    known.basis.values(rule.point(q), L.data());
    for (std::size_t k = 0; k < L.size(); ++k)
      coefficients[k] += rule.weights[std::size_t(q)] * values[q] * L[k];
  }
  const auto isLower = [](const Part& a, const Part& b) { return a.top() < b.top(); };
  std::vector<Part> parts{part(known, coefficients, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}})};
  double attained = -HUGE_VAL;
  const auto attain = [&](const Part& piece) {
    for (const std::size_t vertex : known.vertices)
      attained = std::max(attained, piece.bernstein[vertex]);
  };
  attain(parts.front());
  const double first = parts.front().top() - attained;
  for (int step = 0; step < mostHalvings && parts.front().top() - attained > closeEnough * first; ++step) {
    std::pop_heap(parts.begin(), parts.end(), isLower);
    const auto both = halves(parts.back().corners);
    parts.pop_back();
    for (const Corners& corners : both) {
      parts.push_back(part(known, coefficients, corners));
      attain(parts.back());
      std::push_heap(parts.begin(), parts.end(), isLower);
    }
  }
  return parts.front().top();
}

double TrianglePieces::distance(const Samples::Piece& piece)
{
  if (piece.normError == 0.0)
    return 0.0;
  const double lebesgue = table(*piece.rule).basis.size(); // (k + 1)(k + 2) / 2
  return (1.0 + lebesgue) * piece.normError;
}

} // namespace ndframe
