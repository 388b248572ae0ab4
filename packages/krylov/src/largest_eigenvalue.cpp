#include "largest_eigenvalue.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

namespace
{

/// Symmetric, diagonal and what stands beside it.
struct Tridiagonal
{
  std::vector<double> diagonal, beside;

  /// How many eigenvalues are below x: sign changes of Sturm's sequence.
  int below(double x) const
  {
    int count = 0;
    double pivot = 1.0;
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      const double coupling = i == 0 ? 0.0 : beside[i - 1] * beside[i - 1];
      pivot = diagonal[i] - x - coupling / (pivot == 0.0 ? 1e-300 : pivot);
      count += pivot < 0.0;
    }
    return count;
  }

  double largest() const
  {
    double low = 0.0, high = 0.0;
    for (std::size_t i = 0; i < diagonal.size(); ++i)
      high = std::max(high, std::abs(diagonal[i]) + (i > 0 ? std::abs(beside[i - 1]) : 0.0) +
                                (i < beside.size() ? std::abs(beside[i]) : 0.0));
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = 0.5 * (low + high);
      (below(middle) == int(diagonal.size()) ? high : low) = middle;
    }
    return high;
  }
};

/// Numbers in (-1, 1) that do not follow the mesh.
double scattered(std::uint64_t number)
{
  number = (number + 1) * 0x9e3779b97f4a7c15u;
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
  return double((number ^ (number >> 27)) >> 11) / double(std::uint64_t(1) << 52) - 1.0;
}

double dotOf(const TpetraVectors& a, const TpetraVectors& b)
{
  return a.getVector(0)->dot(*b.getVector(0));
}

/// y := D^-1/2 K D^-1/2 x
void applyScaled(const BlockOperator& K, const std::vector<double>& scale, const TpetraVectors& x, TpetraVectors& y,
                 TpetraVectors& work)
{
  {
    const auto given = x.getData(0);
    const auto scaled = work.getDataNonConst(0);
    for (std::size_t i = 0; i < scale.size(); ++i)
      scaled.getRawPtr()[i] = scale[i] * given.getRawPtr()[i];
  }
  const auto result = y.getDataNonConst(0);
  double* const values = result.getRawPtr();
  K.eachRow(work, [&](std::size_t i, double product) { values[i] = scale[i] * product; });
}

} // namespace

double largestEigenvalue(const BlockOperator& K, const std::vector<double>& inverseDiagonal, int steps)
{
  std::vector<double> scale;
  for (const double inverse : inverseDiagonal)
    scale.push_back(std::sqrt(inverse));
  const auto map = K.getDomainMap();
  TpetraVectors previous(map, 1), current(map, 1), next(map, 1), work(map, 1);
  for (std::size_t i = 0; i < scale.size(); ++i)
    if (scale[i] > 0.0)
      current.replaceLocalValue(int(i), 0, scattered(std::uint64_t(map->getGlobalElement(int(i)))));
  current.scale(1.0 / std::sqrt(dotOf(current, current)));
  Tridiagonal T;
  for (int step = 0; step < steps; ++step) {
    applyScaled(K, scale, current, next, work);
    T.diagonal.push_back(dotOf(current, next));
    next.update(-T.diagonal.back(), current, step == 0 ? 0.0 : -T.beside.back(), previous, 1.0);
    const double length = std::sqrt(dotOf(next, next));
    if (step + 1 == steps || !(length > 1e-12 * T.diagonal.back()))
      break;
    T.beside.push_back(length);
    std::swap(previous, current);
    std::swap(current, next);
    current.scale(1.0 / length);
  }
  return T.largest();
}

} // namespace ndframe
