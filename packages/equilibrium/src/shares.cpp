#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/static_data.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// Enough for phi_a lambda_b times polynomials of degree 3.
constexpr int exactDegree = 5;

} // namespace

Shares::Shares(const MomentBasis& basis, int order) : dim_(basis.dim()), modes_(basis.size())
{
  NDFRAME_ASSERT(order == 1 || order == 2, "displacements of order 1 or 2");
  const int vertices = dim_ + 1;
  one_.assign(std::size_t(vertices) * std::size_t(modes_), 0.0);
  if (order == 1) {
    for (int a = 0; a < vertices; ++a)
      basis.vertexForce(a, &one_[std::size_t(a) * std::size_t(modes_)]);
    for (double& moment : one_)
      moment /= vertices;
    return;
  }
  linear_.assign(std::size_t(vertices) * std::size_t(vertices) * std::size_t(modes_), 0.0);
  const QuadratureRule rule = simplexRule(dim_, exactDegree);
  std::vector<double> m(std::size_t(modes_), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    const double* lambda = rule.point(q);
    basis.values(lambda, m.data());
    for (int a = 0; a < vertices; ++a)
      for (int k = 0; k < modes_; ++k) {
        const double moment = rule.weights[std::size_t(q)] * lambda[a] * m[std::size_t(k)];
        one_[std::size_t(a) * std::size_t(modes_) + std::size_t(k)] += moment;
        for (int b = 0; b < vertices; ++b)
          linear_[(std::size_t(a) * std::size_t(vertices) + std::size_t(b)) * std::size_t(modes_) + std::size_t(k)] +=
              moment * lambda[b];
      }
  }
}

const double* Shares::ofLinear(int a, int b) const
{
  NDFRAME_ASSERT(!linear_.empty(), "displacements of order 1 have constant stresses");
  return linear_.data() + (std::ptrdiff_t(a) * (dim_ + 1) + b) * modes_;
}

} // namespace ndframe
