#include "ndframe/algebra/band.hpp"

#include <utility>

#include "lapack.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

BandCholesky::BandCholesky(BandMatrix A) : factor_(std::move(A))
{
  const int n = factor_.size(), bandwidth = factor_.bandwidth(), rows = bandwidth + 1;
  int info = 0;
  if (n > 0)
    dpbtrf_("L", &n, &bandwidth, factor_.data(), &rows, &info);
  NDFRAME_ASSERT(info >= 0, "dpbtrf refused an argument");
  if (info > 0)
    throw NotPositiveDefinite{info - 1};
}

Vector BandCholesky::solve(Vector b) const
{
  const int n = factor_.size(), bandwidth = factor_.bandwidth(), rows = bandwidth + 1, one = 1;
  NDFRAME_ASSERT(n == int(b.size()), "shapes do not match");
  int info = 0;
  if (n > 0)
    dpbtrs_("L", &n, &bandwidth, &one, factor_.data(), &rows, b.data(), &n, &info);
  NDFRAME_ASSERT(info == 0, "dpbtrs refused an argument");
  return b;
}

} // namespace ndframe
