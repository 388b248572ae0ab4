#include "polynomial_values.hpp"

#include "box_polynomial.hpp"
#include "packed_rows.hpp"

namespace ndframe
{
namespace
{

/// Horner's scheme in the first two coordinates. row: one past the last coefficient; comes back at the first.
template <int packs>
inline __attribute__((always_inline)) void horner(const double*& row, int degree, const Pack* x, const Pack* y,
                                                  Pack* sum)
{
  for (int p = 0; p < packs; ++p)
    sum[p] = Pack{};
  for (int j = degree; j >= 0; --j) {
    row -= degree - j + 1;
    Pack inner[packs] = {};
    for (int i = degree - j; i >= 0; --i)
      for (int p = 0; p < packs; ++p)
        inner[p] = inner[p] * x[p] + row[i];
    for (int p = 0; p < packs; ++p)
      sum[p] = sum[p] * y[p] + inner[p];
  }
}

/// A simplex and a rule's coordinates in it, each of them in a row of its own.
struct Points
{
  const BoxCorners& corners;
  const double* lambda;
  std::size_t stride;
  int vertices;
};

/// A coordinate of packs of points.
template <int packs>
inline __attribute__((always_inline)) void place(const Points& at, std::size_t axis, Pack* x)
{
  for (int p = 0; p < packs; ++p) {
    x[p] = Pack{};
    for (int v = 0; v < at.vertices; ++v) {
      Pack lambda;
      load(at.lambda + std::size_t(v) * at.stride + packLanes * std::size_t(p), lambda);
      x[p] += lambda * at.corners[axis][std::size_t(v)];
    }
  }
}

/// Values at packs of points. Returns `packs`.
template <int packs>
inline __attribute__((always_inline)) int evaluate(const double* coefficients, int degree, int dim, const Points& at,
                                                   double* result)
{
  Pack x[packs], y[packs], sum[packs];
  place<packs>(at, 0, x);
  place<packs>(at, 1, y);
  const double* row = coefficients + numProducts(dim, degree);
  if (dim == 2)
    horner<packs>(row, degree, x, y, sum);
  else {
    Pack z[packs], slice[packs];
    place<packs>(at, 2, z);
    for (int p = 0; p < packs; ++p)
      sum[p] = Pack{};
    for (int k = degree; k >= 0; --k) {
      horner<packs>(row, degree - k, x, y, slice);
      for (int p = 0; p < packs; ++p)
        sum[p] = sum[p] * z[p] + slice[p];
    }
  }
  for (int p = 0; p < packs; ++p)
    store(sum[p], result + packLanes * std::size_t(p));
  return packs;
}

/// As many as the triangles' rules of 6, 7, 12, 16, 19 and 25 points need; others in parts.
NDFRAME_EVERY_PROCESSOR int evaluate(const double* coefficients, int degree, int dim, int packs, const Points& at,
                                     double* result)
{
  switch (packs) {
  case 7:
    return evaluate<7>(coefficients, degree, dim, at, result);
  case 5:
    return evaluate<5>(coefficients, degree, dim, at, result);
  case 3:
    return evaluate<3>(coefficients, degree, dim, at, result);
  case 2:
    return evaluate<2>(coefficients, degree, dim, at, result);
  case 1:
    return evaluate<1>(coefficients, degree, dim, at, result);
  default:
    return evaluate<4>(coefficients, degree, dim, at, result);
  }
}

} // namespace

void polynomialValues(const double* coefficients, int degree, int dim, const BoxCorners& corners,
                      const SamplingRule& sampling, double* result)
{
  const int vertices = sampling.rule.dim + 1;
  const std::size_t stride = sampling.padded.size() / std::size_t(vertices), packs = stride / packLanes;
  for (std::size_t pack = 0; pack < packs;)
    pack += std::size_t(evaluate(coefficients, degree, dim, int(packs - pack),
                                 {corners, sampling.padded.data() + packLanes * pack, stride, vertices},
                                 result + packLanes * pack));
}

} // namespace ndframe
