#include "polynomial_values.hpp"

#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

/// Points that are worked on side by side. Wider ones are slower where the processor has no such registers.
using Pack = double __attribute__((vector_size(4 * sizeof(double))));
constexpr std::size_t lanes = 4;

/// Horner's scheme in both coordinates.
template <int packs>
inline __attribute__((always_inline)) void horner(const double* coefficients, int degree, const Pack* x, const Pack* y,
                                                  double* result)
{
  Pack sum[packs] = {};
  const double* row = coefficients + std::size_t(degree + 1) * std::size_t(degree + 2) / 2;
  for (int j = degree; j >= 0; --j) {
    row -= degree - j + 1;
    Pack inner[packs] = {};
    for (int i = degree - j; i >= 0; --i)
      for (int p = 0; p < packs; ++p)
        inner[p] = inner[p] * x[p] + row[i];
    for (int p = 0; p < packs; ++p)
      sum[p] = sum[p] * y[p] + inner[p];
  }
  for (int p = 0; p < packs; ++p)
    store(sum[p], result + lanes * std::size_t(p));
}

/// Values at packs of points given by their barycentric coordinates, each of them in a row of its own. Returns `packs`.
template <int packs>
inline __attribute__((always_inline)) int evaluate(const double* coefficients, int degree,
                                                   const TriangleCorners& corners, const double* lambda,
                                                   std::size_t stride, double* result)
{
  Pack x[packs], y[packs];
  for (int p = 0; p < packs; ++p) {
    Pack a, b, c;
    load(lambda + lanes * std::size_t(p), a);
    load(lambda + stride + lanes * std::size_t(p), b);
    load(lambda + 2 * stride + lanes * std::size_t(p), c);
    x[p] = a * corners.xi[0] + b * corners.xi[1] + c * corners.xi[2];
    y[p] = a * corners.eta[0] + b * corners.eta[1] + c * corners.eta[2];
  }
  horner<packs>(coefficients, degree, x, y, result);
  return packs;
}

/// As many as the rules of 6, 7, 12, 16, 19 and 25 points need; others in parts.
NDFRAME_EVERY_PROCESSOR int evaluate(const double* coefficients, int degree, int packs, const TriangleCorners& corners,
                                     const double* lambda, std::size_t stride, double* result)
{
  switch (packs) {
  case 7:
    return evaluate<7>(coefficients, degree, corners, lambda, stride, result);
  case 5:
    return evaluate<5>(coefficients, degree, corners, lambda, stride, result);
  case 3:
    return evaluate<3>(coefficients, degree, corners, lambda, stride, result);
  case 2:
    return evaluate<2>(coefficients, degree, corners, lambda, stride, result);
  case 1:
    return evaluate<1>(coefficients, degree, corners, lambda, stride, result);
  default:
    return evaluate<4>(coefficients, degree, corners, lambda, stride, result);
  }
}

} // namespace

void polynomialValues(const double* coefficients, int degree, const TriangleCorners& corners,
                      const SamplingRule& sampling, double* result)
{
  const std::size_t stride = sampling.padded.size() / 3, packs = stride / lanes;
  for (std::size_t pack = 0; pack < packs;)
    pack += std::size_t(evaluate(coefficients, degree, int(packs - pack), corners,
                                 sampling.padded.data() + lanes * pack, stride, result + lanes * pack));
}

} // namespace ndframe
