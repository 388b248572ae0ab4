#include <basix/quadrature.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

QuadratureRule compactRule(int dim, int degree)
{
  NDFRAME_ASSERT((dim == 2 || dim == 3) && degree >= 1, "no compact quadrature rule of this kind");
  const bool isTabulated = degree <= (dim == 2 ? 30 : 15);
  const auto [points, weights] = basix::quadrature::make_quadrature(
      isTabulated ? basix::quadrature::type::xiao_gimbutas : basix::quadrature::type::gauss_jacobi,
      dim == 2 ? basix::cell::type::triangle : basix::cell::type::tetrahedron, degree);
  const auto corners = std::size_t(dim) + 1;
  const double unitSimplices = dim == 2 ? 2.0 : 6.0; // in a cube
  QuadratureRule rule{dim, std::vector<double>(weights.size() * corners), {}};
  for (std::size_t q = 0; q < weights.size(); ++q) {
    double* const lambda = rule.lambda.data() + q * corners;
    lambda[0] = 1.0;
    for (std::size_t k = 1; k < corners; ++k) {
      lambda[k] = points[q * std::size_t(dim) + k - 1];
      lambda[0] -= lambda[k];
    }
    rule.weights.push_back(unitSimplices * weights[q]);
  }
  return rule;
}

} // namespace ndframe
