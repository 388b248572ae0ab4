// Integrates x^2 over a triangle by a rule of degree 2, and its projection on affine functions by orthonormal
// polynomials.
#include <cmath>

#include "ndframe/fem/moment_basis.hpp"
#include "ndframe/fem/quadrature.hpp"

using namespace ndframe;

int main()
{
  const QuadratureRule rule = simplexRule(2, 4);
  const MomentBasis affine = MomentBasis::polynomials(2, 1);
  std::vector<double> moments(3, 0.0), m(3);
  double square = 0.0; // the mean of x^4 on the triangle (0, 0), (1, 0), (0, 1), where x is the second coordinate
  for (int q = 0; q < rule.size(); ++q) {
    const double x = rule.point(q)[1], weight = rule.weights[std::size_t(q)];
    affine.values(rule.point(q), m.data());
    square += weight * std::pow(x, 4);
    for (std::size_t k = 0; k < 3; ++k)
      moments[k] += weight * x * x * m[k];
  }
  // int x^n = n! / (n + 2)! on this triangle of area 1/2; the first function is 1, so its moment is the mean value.
  const bool areRight = std::abs(moments[0] - 1.0 / 6.0) < 1e-15 && std::abs(square - 1.0 / 15.0) < 1e-15;
  double projected = 0.0;
  for (const double moment : moments)
    projected += moment * moment;
  return areRight && projected < square ? 0 : 1; // Bessel's inequality
}
