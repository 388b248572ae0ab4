#include "ndframe/admissibility/edge_functions.hpp"

#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

void edgeFunctions(int order, const double* lambda, double* N)
{
  if (order == 1)
    Lagrange<1, 1>::values(lambda, N);
  else
    Lagrange<1, 2>::values(lambda, N);
}

DenseMatrix edgeMoments(int order, int degree)
{
  const MomentBasis basis = facetBasis(2, degree);
  const QuadratureRule rule = simplexRule(1, order + degree);
  DenseMatrix moments(order + 1, basis.size());
  Vector L(std::size_t(basis.size()));
  double N[3];
  for (int g = 0; g < rule.size(); ++g) {
    edgeFunctions(order, rule.point(g), N);
    basis.values(rule.point(g), L.data());
    for (int k = 0; k < moments.cols(); ++k)
      for (int i = 0; i < moments.rows(); ++i)
        moments(i, k) += rule.weights[std::size_t(g)] * N[i] * L[std::size_t(k)];
  }
  return moments;
}

} // namespace ndframe
