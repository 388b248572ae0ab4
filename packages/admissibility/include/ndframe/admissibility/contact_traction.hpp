#pragma once

#include <vector>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// One facet of an interface as recovery sees it (2-D): an edge on each of two bodies, the same one or drawn apart.
/// Tractions are forces per length of the interface's first side: t n_c there, -t n_c times the ratio of the two
/// lengths on the other side.
struct ContactFacet
{
  int dirichletBody = 0, neumannBody = 0;
  Facet dirichlet, neumann;
  Direction normal{};               ///< n_c on this facet: outward normal of the Dirichlet body
  double measure = 0.0;             ///< length, on the interface's first side
  bool reversed = false;            ///< the ascending vertex order of the Neumann body runs the other way
  std::array<int, 3> nodes{};       ///< interface nodes: Dirichlet body's ascending vertices, then (order 2) the middle
  std::array<int, 3> pairs{};       ///< their pairs of body nodes: nodes, but for the second node of a corner the first
  bool turns = false;               ///< n_c turns along the facet: linear between `ends`
  std::array<Direction, 2> ends{};  ///< n_c at the vertices (nodes 0, 1) where it turns
  bool isDrawnApart = false;        ///< the distance of the two sides as they are drawn is a part of the gap
  std::array<Direction, 3> drawn{}; ///< then x1 - x2 at the nodes, of the displacements' order in between
  std::array<Direction, 2> points{}; ///< its vertices on the interface's first side

  /// n_c at a node of the facet (0, 1 the vertices, 2 the middle).
  Direction normalAt(std::size_t node) const;
};

/// Normal tractions t_N <= 0 on the facets of all interfaces, as polynomials of degree q that may jump from facet to
/// facet, divided into the shares of the two vertices' stars. Acts on the Dirichlet body along n_c, on the Neumann
/// body against it.
struct ContactTraction
{
  int degree = 0;
  Vector shares; ///< per facet, per vertex (ascending on the Dirichlet side), per mode: int t_a L_k, a force
  /// Where n_c turns: what the stresses carry of t n_c, which is of one degree more than t (contactOscillation has the
  /// rest). Laid out like `shares` with two components a mode; zero on facets that do not turn, empty without any that
  /// does.
  Vector vectors{};

  /// Moments of the whole traction on a facet (degree + 1 values).
  Vector moments(int facet) const;
};

/// Bernstein coefficients (rows, ascending from a facet's first vertex) of the polynomials with unit moments (columns)
/// on a facet of unit measure: sum_k T_k L_k / |f| has the coefficients bernsteinOfMoments T / |f|.
DenseMatrix bernsteinOfMoments(int degree);

/// Largest Bernstein coefficient of t_N over all facets: not above 0 means t_N <= 0 everywhere.
double largestBernstein(const ContactTraction& traction, const std::vector<ContactFacet>& facets);

/// A traction from nodal values: continuous, of the displacements' order, shares as StaticData explains them.
ContactTraction tractionFromNodes(const std::vector<ContactFacet>& facets, const Vector& nodal, int order, int degree);

/// The shares of one body's contact facets in global axes, as FieldInput::contact wants them: `onDirichlet` along n_c
/// where it is the Dirichlet body of the facet, `onNeumann` against n_c elsewhere (a body of a network may be both).
/// The body's facets are those of `facets` that it takes part in, in their order.
Vector contactShares(const std::vector<ContactFacet>& facets, const ContactTraction& onDirichlet,
                     const ContactTraction& onNeumann, int body, int dim);

} // namespace ndframe
