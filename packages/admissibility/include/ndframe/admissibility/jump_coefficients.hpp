#pragma once

#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{

/// The normal jump w = (u1 - u2) . n_c on a patch in Bernstein coefficients, in the order of the nodes
/// (bernsteinWeight). Where n_c turns along an edge of the plane there is one more (n_c and u1 - u2 multiply), and they
/// ascend from the first vertex:
///
///   order 1:  n_0.j_0,  (n_0.j_1 + n_1.j_0) / 2,  n_1.j_1
///   order 2:  n_0.j_0,  (n_1.j_0 + 2 n_0.J) / 3,  (n_0.j_1 + 2 n_1.J) / 3,  n_1.j_1,     J = 2 j_2 - (j_0 + j_1) / 2
///
/// j_i: u1 - u2 at ContactPatch::nodes.
struct JumpCoefficients
{
  const ContactPatch& patch; ///< must outlive this
  int order;                 ///< of the displacements, 1 or 2

  std::size_t size() const; ///< number of coefficients
  /// The coefficient that is the value at a vertex.
  std::size_t atVertex(std::size_t vertex) const;
  /// Those that the node in the middle of an edge decides.
  std::vector<std::size_t> atMiddle(std::size_t node) const;
  /// Coefficient k = sum over the patch's nodes of weight(k, node) . j.
  Direction weight(std::size_t k, std::size_t node) const;
  double of(std::size_t k, const PatchVectors& opening) const; ///< coefficient k, a length, for these j_i
  /// A polynomial of the displacements' order in as many coefficients, from its own in the order of the nodes.
  double gap(std::size_t k, const double* bernstein) const;
};

} // namespace ndframe
