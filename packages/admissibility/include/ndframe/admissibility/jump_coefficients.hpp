#pragma once

#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{

/// The normal jump w = (u1 - u2) . n_c on a patch in Bernstein coefficients, in the order of the nodes
/// (bernsteinWeight). Where n_c turns along the patch, n_c and u1 - u2 multiply: the product has one degree more and,
/// in the order of bernsteinPowers(), on edges ascending from the first vertex,
///
///   order 1:  n_0.j_0,  (n_0.j_1 + n_1.j_0) / 2,  n_1.j_1
///   order 2:  n_0.j_0,  (n_1.j_0 + 2 n_0.J) / 3,  (n_0.j_1 + 2 n_1.J) / 3,  n_1.j_1,     J = 2 j_2 - (j_0 + j_1) / 2
///
/// along every edge and (n_0.J_12 + n_1.J_20 + n_2.J_01) / 3 inside triangles of order 2; of exponents a the
/// coefficient sum_e a_e n_e . J_(a - 1_e) / (order + 1). j_i: u1 - u2 at ContactPatch::nodes.
struct JumpCoefficients
{
  const ContactPatch& patch; ///< must outlive this
  int order;                 ///< of the displacements, 1 or 2

  std::size_t size() const; ///< number of coefficients
  /// The coefficient that is the value at a vertex.
  std::size_t atVertex(std::size_t vertex) const;
  /// Those that the node in the middle of an edge decides.
  std::vector<std::size_t> atMiddle(std::size_t node) const;
  /// Where n_c turns, those between an edge's vertices; inside: and inside the patch.
  std::vector<std::size_t> alongEdge(std::size_t edge, bool inside) const;
  /// Coefficient k = sum over the patch's nodes of weight(k, node) . j.
  Direction weight(std::size_t k, std::size_t node) const;
  double of(std::size_t k, const PatchVectors& opening) const; ///< coefficient k, a length, for these j_i
  /// A polynomial of the displacements' order in as many coefficients, from its own in the order of the nodes.
  double gap(std::size_t k, const double* bernstein) const;
};

} // namespace ndframe
