#include "largest_eigenvalue.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>

namespace ndframe
{

namespace
{

/// Of a symmetric tridiagonal matrix: its diagonal and what stands beside it.
double largestOf(std::vector<double> diagonal, std::vector<double> beside)
{
  const int n = int(diagonal.size());
  int info = 0;
  std::vector<double> work(std::size_t(std::max(1, 2 * n - 2)));
  Teuchos::LAPACK<int, double>().STEQR('N', n, diagonal.data(), beside.data(), nullptr, 1, work.data(), &info);
  TEUCHOS_TEST_FOR_EXCEPTION(info != 0, std::runtime_error, "the eigenvalues of a tridiagonal matrix were not found");
  return diagonal.back();
}

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
void applyScaled(const FineOperator& K, const std::vector<double>& scale, const TpetraVectors& x, TpetraVectors& y,
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
  K.multiply(work, values);
  for (std::size_t i = 0; i < scale.size(); ++i)
    values[i] *= scale[i];
}

} // namespace

double largestEigenvalue(const FineOperator& K, const std::vector<double>& inverseDiagonal, int steps)
{
  std::vector<double> scale;
  for (const double inverse : inverseDiagonal)
    scale.push_back(std::sqrt(inverse));
  const auto map = K.getDomainMap();
  TpetraVectors previous(map, 1), current(map, 1), next(map, 1), work(map, 1);
  {
    const std::vector<std::int64_t> numbers = K.numbers();
    for (std::size_t i = 0; i < scale.size(); ++i)
      if (scale[i] > 0.0)
        current.replaceLocalValue(int(i), 0, scattered(std::uint64_t(numbers[i])));
  }
  current.scale(1.0 / std::sqrt(dotOf(current, current)));
  std::vector<double> diagonal, beside;
  for (int step = 0; step < steps; ++step) {
    applyScaled(K, scale, current, next, work);
    diagonal.push_back(dotOf(current, next));
    next.update(-diagonal.back(), current, step == 0 ? 0.0 : -beside.back(), previous, 1.0);
    const double length = std::sqrt(dotOf(next, next));
    if (step + 1 == steps || !(length > 1e-12 * diagonal.back()))
      break;
    beside.push_back(length);
    std::swap(previous, current);
    std::swap(current, next);
    current.scale(1.0 / length);
  }
  return largestOf(std::move(diagonal), std::move(beside));
}

} // namespace ndframe
