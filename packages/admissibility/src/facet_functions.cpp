#include "ndframe/admissibility/facet_functions.hpp"

#include <utility>

#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

FacetEdges facetEdges(int dim)
{
  if (dim == 2)
    return {int(SimplexEdges<1>::vertices.size()), SimplexEdges<1>::vertices.data()};
  return {int(SimplexEdges<2>::vertices.size()), SimplexEdges<2>::vertices.data()};
}

int numFacetNodes(int dim, int order)
{
  return order == 1 ? dim : dim + facetEdges(dim).size;
}

int numFacetModes(int dim, int degree)
{
  int modes = 1;
  for (int d = 1; d < dim; ++d)
    modes = modes * (degree + d) / d;
  return modes;
}

std::array<int, 3> ascendingPlaces(int dim, const int* numbers)
{
  std::array<int, 3> places{0, 1, 2};
  for (std::size_t last = 1; last < std::size_t(dim); ++last)
    for (std::size_t i = last; i > 0 && numbers[places[i]] < numbers[places[i - 1]]; --i)
      std::swap(places[i], places[i - 1]);
  return places;
}

void facetFunctions(int dim, int order, const double* lambda, double* N)
{
  withDimAndOrder(dim, order, [&](auto space, auto p) { Lagrange<space() - 1, p()>::values(lambda, N); });
}

DenseMatrix facetMoments(int dim, int order, int degree)
{
  const MomentBasis basis = facetBasis(dim, degree);
  const QuadratureRule rule = simplexRule(dim - 1, order + degree);
  DenseMatrix moments(numFacetNodes(dim, order), basis.size());
  Vector L(std::size_t(basis.size()));
  double N[mostFacetNodes] = {};
  for (int g = 0; g < rule.size(); ++g) {
    facetFunctions(dim, order, rule.point(g), N);
    basis.values(rule.point(g), L.data());
    for (int k = 0; k < moments.cols(); ++k)
      for (int i = 0; i < moments.rows(); ++i)
        moments(i, k) += rule.weights[std::size_t(g)] * N[i] * L[std::size_t(k)];
  }
  return moments;
}

std::vector<std::array<int, 3>> bernsteinPowers(int dim, int degree)
{
  std::vector<std::array<int, 3>> powers;
  for (int i = degree; i >= 0; --i)
    for (int j = degree - i; j >= (dim == 2 ? degree - i : 0); --j)
      powers.push_back({i, j, degree - i - j});
  return powers;
}

double bernsteinWeight(int dim, int order, int coefficient, int node)
{
  if (order == 1 || coefficient < dim)
    return coefficient == node ? 1.0 : 0.0;
  if (coefficient == node)
    return 2.0;
  const auto& ends = facetEdges(dim).ends[coefficient - dim];
  return node == ends[0] || node == ends[1] ? -0.5 : 0.0;
}

} // namespace ndframe
