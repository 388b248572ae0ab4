#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

MomentBasis facetBasis(int dim, int degree)
{
  return MomentBasis::polynomials(dim - 1, degree);
}

MomentBasis loadBasis(int dim, int degree)
{
  return degree == 1 ? MomentBasis::piecewiseConstant(dim) : MomentBasis::polynomials(dim, degree - 1);
}

} // namespace ndframe
