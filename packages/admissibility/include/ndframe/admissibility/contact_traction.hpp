#pragma once

#include <map>
#include <vector>

#include "ndframe/admissibility/facet_functions.hpp"
#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// One facet of an interface as recovery sees it: an edge or triangle on each of two bodies, the same one or (edges)
/// drawn apart. Tractions are forces per length or area of the interface's first side: t n_c there, -t n_c times the
/// ratio of the two lengths on the other side.
struct ContactFacet
{
  int dim = 2;                                                          ///< of space
  int dirichletBody = 0, /**< in the list of bodies */ neumannBody = 0; ///< the same one where it touches itself
  Facet dirichlet, /**< on the mesh of its body */ neumann;             ///< the same on the other one
  Direction normal{};                 ///< n_c on this facet: outward normal of the Dirichlet body
  double measure = 0.0;               ///< length or area, on the interface's first side
  std::array<int, 3> theirs{0, 1, 2}; ///< the Neumann body's ascending vertices by their places among the Dirichlet's
  FacetNodes nodes{}; ///< interface nodes: Dirichlet body's ascending vertices, then (order 2) the middles (FacetEdges)
  FacetNodes pairs{}; ///< their pairs of body nodes: nodes, but for the second node of a corner the first
  bool turns = false; ///< n_c turns along the facet: linear between `ends`
  std::array<Direction, 2> ends{};   ///< n_c at the vertices (nodes 0, 1) where it turns
  bool isDrawnApart = false;         ///< the distance of the two sides as they are drawn is a part of the gap
  std::array<Direction, 3> drawn{};  ///< then x1 - x2 at the nodes, of the displacements' order in between
  std::array<Direction, 3> points{}; ///< its vertices on the interface's first side

  /// The two are one where a body touches itself.
  int body(bool isDirichlet) const { return isDirichlet ? dirichletBody : neumannBody; }
  /// An edge on which the ascending vertex order of the Neumann body runs the other way.
  bool isReversed() const { return theirs[0] == 1; }
  /// n_c at a node of the facet (0, 1 the vertices of an edge, 2 the middle).
  Direction normalAt(std::size_t node) const;
};

/// A facet, seen from one of the bodies that meet there.
struct FacetSide
{
  int facet;        ///< in the list of contact facets
  bool isDirichlet; ///< seen from its Dirichlet body, else from the other one
};

/// The facets that a body takes part in, in their order; a facet on which it touches itself twice.
std::vector<FacetSide> facetsOfBody(const std::vector<ContactFacet>& facets, int body);

/// Normal tractions t_N <= 0 on the facets of all interfaces, as polynomials of degree q that may jump from facet to
/// facet, divided into the shares of the vertices' stars. Acts on the Dirichlet body along n_c, on the Neumann
/// body against it.
struct ContactTraction
{
  int degree = 0; ///< q, at least the order of the displacements
  Vector shares;  ///< per facet, per vertex (ascending on the Dirichlet side), per mode: int t_a L_k, a force
  /// Where n_c turns: what the stresses carry of t n_c, which is of one degree more than t (contactOscillation has the
  /// rest). Laid out like `shares` with two components a mode; zero on facets that do not turn, empty without any that
  /// does.
  Vector vectors{};
  int dim = 2; ///< of space

  /// Polynomials on a facet: degree + 1 on edges.
  std::size_t numModes() const;
  /// Moments of the whole traction on a facet, per mode.
  Vector moments(int facet) const;
};

/// Bernstein coefficients (rows; on edges ascending from the first vertex) of the polynomials with unit moments
/// (columns) on a facet of unit measure: sum_k T_k L_k / |f| has the coefficients bernsteinOfMoments T / |f|.
DenseMatrix bernsteinOfMoments(int dim, int degree);

/// How the moments of a function follow when the facet's vertices are taken in another order: L_k of the coordinates
/// lambda_theirs(0), lambda_theirs(1), .. has the mean values R(k, j) with L_j. On edges 1 and -1.
DenseMatrix modesInOrder(int dim, int degree, const std::array<int, 3>& theirs);

/// modesInOrder() for the facets of a scene: every order is found once.
class OrderedModes
{
public:
  OrderedModes(int dim, int degree) : dim_(dim), degree_(degree) {} ///< dim: of space; degree: q
  const DenseMatrix& operator()(const std::array<int, 3>& theirs);  ///< R, as long as this object lives

private:
  int dim_, degree_;
  std::map<std::array<int, 3>, DenseMatrix> found_;
};

/// Largest Bernstein coefficient of t_N over all facets: not above 0 means t_N <= 0 everywhere.
double largestBernstein(const ContactTraction& traction, const std::vector<ContactFacet>& facets);

/// A traction from nodal values: continuous, of the displacements' order, shares as StaticData explains them.
ContactTraction tractionFromNodes(const std::vector<ContactFacet>& facets, const Vector& nodal, int order, int degree);

/// The shares of one body's contact facets in global axes, as FieldInput::contact wants them: `onDirichlet` along n_c
/// where it is the Dirichlet body of the facet, `onNeumann` against n_c elsewhere (a body of a network may be both).
/// The body's facets are those of `facets` that it takes part in, in their order.
Vector contactShares(const std::vector<ContactFacet>& facets, const ContactTraction& onDirichlet,
                     const ContactTraction& onNeumann, int body);

} // namespace ndframe
