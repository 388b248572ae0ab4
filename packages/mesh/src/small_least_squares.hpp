#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace ndframe
{

/// A few equations for n unknowns, solved by least squares; combinations of unknowns that the equations say little
/// about stay near zero.
///
/// Iterated Tikhonov: x += (A^T A + eps)^-1 A^T (b - A x). What has eigenvalues far above eps is solved exactly, what
/// has some far below not at all.
template <int n>
class SmallLeastSquares
{
public:
  using Row = std::array<double, std::size_t(n)>;

  void add(const Row& row, double right, double weight)
  {
    for (std::size_t i = 0; i < row.size(); ++i) {
      b_[i] += weight * weight * row[i] * right;
      for (std::size_t j = 0; j < row.size(); ++j)
        A_[i][j] += weight * weight * row[i] * row[j];
    }
  }

  Row solution() const { return iterated(b_); }

  /// Whether the equations say what an unknown is, whatever the others are.
  bool determines(std::size_t unknown) const
  {
    constexpr double nearly = 1.0 - 1e-10;
    Row column{}; // of A^T A: its solution is the projection of the unknown onto what is determined
    for (std::size_t i = 0; i < column.size(); ++i)
      column[i] = A_[i][unknown];
    return iterated(column)[unknown] > nearly;
  }

private:
  static constexpr double relative = 1e-3; ///< eps, of the mean eigenvalue
  static constexpr int steps = 40;
  static constexpr double roundOff = 1e-16;

  Row iterated(const Row& right) const
  {
    auto L = A_;
    double trace = 0.0;
    for (std::size_t i = 0; i < L.size(); ++i)
      trace += A_[i][i];
    for (std::size_t i = 0; i < L.size(); ++i)
      L[i][i] += relative * trace / n;
    for (std::size_t j = 0; j < L.size(); ++j) // Cholesky
      for (std::size_t i = j; i < L.size(); ++i) {
        for (std::size_t k = 0; k < j; ++k)
          L[i][j] -= L[i][k] * L[j][k];
        L[i][j] = i == j ? std::sqrt(L[j][j]) : L[i][j] / L[j][j];
      }
    Row x{};
    double change = 1.0, size = 0.0;
    for (int step = 0; step < steps && change > roundOff * size; ++step) {
      change = size = 0.0;
      Row rest = right;
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j)
          rest[i] -= A_[i][j] * x[j];
      for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
          rest[i] -= L[i][k] * rest[k];
        rest[i] /= L[i][i];
      }
      for (std::size_t i = x.size(); i-- > 0;) {
        for (std::size_t k = i + 1; k < x.size(); ++k)
          rest[i] -= L[k][i] * rest[k];
        rest[i] /= L[i][i];
        x[i] += rest[i];
        change = std::max(change, std::abs(rest[i]));
        size = std::max(size, std::abs(x[i]));
      }
    }
    return x;
  }

  std::array<Row, std::size_t(n)> A_{};
  Row b_{};
};

} // namespace ndframe
