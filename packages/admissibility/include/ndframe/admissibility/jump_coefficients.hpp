#pragma once

#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{

/// The normal jump w = (u1 - u2) . n_c on a facet in Bernstein coefficients. On triangles in the order of the nodes
/// (bernsteinWeight). On edges ascending from the facet's first vertex, as many as the displacements' order and one,
/// one more where n_c turns (n_c and u1 - u2 multiply):
///
///   order 1:  n_0.j_0,  (n_0.j_1 + n_1.j_0) / 2,  n_1.j_1
///   order 2:  n_0.j_0,  (n_1.j_0 + 2 n_0.J) / 3,  (n_0.j_1 + 2 n_1.J) / 3,  n_1.j_1,     J = 2 j_2 - (j_0 + j_1) / 2
///
/// j_i: u1 - u2 at ContactFacet::nodes.
struct JumpCoefficients
{
  const ContactFacet& facet; ///< must outlive this
  int order;                 ///< of the displacements, 1 or 2

  std::size_t size() const; ///< number of coefficients
  /// The coefficient that is the value at a vertex.
  std::size_t atVertex(std::size_t vertex) const;
  /// Those that the node in the middle of an edge decides.
  std::vector<std::size_t> atMiddle(std::size_t node) const;
  /// Coefficient k = sum over the facet's nodes of weight(k, node) . j.
  Direction weight(std::size_t k, std::size_t node) const;
  double of(std::size_t k, const FacetVectors& opening) const; ///< coefficient k, a length, for these j_i
  /// A polynomial of the displacements' order in as many coefficients: gap points to its own.
  double gap(std::size_t k, const double* bernstein) const;
};

} // namespace ndframe
