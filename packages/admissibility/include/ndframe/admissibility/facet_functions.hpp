#pragma once

#include <array>
#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Nodes of a facet at most: a triangle's vertices and the middles of its edges.
constexpr std::size_t mostFacetNodes = 6;
/// Node numbers of a facet, vertices first; what a facet does not have is not set.
using FacetNodes = std::array<int, mostFacetNodes>;

/// Nodes of a facet of a body of dimension `dim` (2, 3) and order 1 or 2: its vertices, then the middles of its edges.
int numFacetNodes(int dim, int order);

/// Polynomials of degree q on a facet: the size of facetBasis().
int numFacetModes(int dim, int degree);

/// The ends of a facet's edges in the order of the nodes in their middles; the plane's facet is one edge.
struct FacetEdges
{
  int size;                       ///< number of edges: 1 or 3
  const std::array<int, 2>* ends; ///< per edge, places among the facet's vertices; static
};
FacetEdges facetEdges(int dim); ///< dim: of the body, 2 or 3

/// The places of `dim` numbers, those of a facet's vertices, in ascending order of the numbers.
std::array<int, 3> ascendingPlaces(int dim, const int* numbers);

/// The nodal functions of a facet at a point with barycentric coordinates lambda (dim values).
void facetFunctions(int dim, int order, const double* lambda, double* N);

/// Their moments 1/|f| int N_i L_k dS, nodes x modes, with the basis of tractions of this degree.
DenseMatrix facetMoments(int dim, int order, int degree);

/// Exponents of the Bernstein polynomials of degree q on a facet; on edges from the first vertex to the second.
std::vector<std::array<int, 3>> bernsteinPowers(int dim, int degree);

/// Bernstein coefficients from nodal values on a facet, nodes x nodes: those of the vertices are the values there, that
/// of an edge vw with the middle m is 2 x_m - (x_v + x_w) / 2.
double bernsteinWeight(int dim, int order, int coefficient, int node);

} // namespace ndframe
