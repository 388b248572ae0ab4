#pragma once

#include <vector>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/mechanics/elasticity.hpp"

namespace ndframe
{

/// Symmetric stresses of degree q on the split (Alfeld, Clough-Tocher) reference simplex, tractions continuous inside
/// (Johnson and Mercier 1978 for q = 1; DESIGN of degrees 2 and 3 checked numerically, docs/theory.md).
///
/// With sigma = F S F^T / |det F| the moments of tractions and loads transform as vectors, T_k = F T^_k, G_k = F G^_k,
/// so one set of tables serves every cell:
///
///   S = lift (T^, G^) + bubbles y,   energy int sigma : C^-1 sigma = 1/|det F| sum_m c_m x^T energy[m] x,  x = (T^,
///   G^, y)
///
/// where c_m are the entries of the compliance pulled back to the reference simplex.
///
/// Data x = (T^, G^) are ordered facet by facet (facet i opposite to vertex i), mode by mode, component by component;
/// then load mode by mode, component by component. They must balance: sum of the tractions' wrenches = the load's.
///
/// Coefficient (sub * strains + strain) * basis.size() + m multiplies function m of `basis` in the barycentric
/// coordinates of sub-cell `sub` (the barycentre takes the place of vertex `sub`).
struct ReferenceStress
{
  int dim = 0, /**< of space */ degree = 0;                            ///< q of the stresses
  int facetModes = 0, /**< functions of facetBasis() */ loadModes = 0; ///< functions of loadBasis()
  int tractions = 0;                                                   ///< (dim + 1) * facetModes * dim
  int loads = 0;                                                       ///< loadModes * dim
  int bubbles = 0; ///< symmetric, divergence-free, traction-free: 0 / 3 / 9 (dim 2, q = 1, 2, 3), 0 / 18 / 66 (dim 3)
  int coefficients = 0; ///< (dim + 1) sub-cells x strains x modes (polynomials of degree <= q)

  MomentBasis basis;               ///< all polynomials of degree <= q on a sub-cell
  DenseMatrix lift;                ///< coefficients x (tractions + loads)
  DenseMatrix bubble;              ///< coefficients x bubbles
  std::vector<DenseMatrix> energy; ///< strains (strains + 1) / 2 matrices of size tractions + loads + bubbles

  int data() const { return tractions + loads; } ///< entries of (T^, G^)
};

/// Tables for degrees 1 to 3; computed on first use (0.3 s for solids of degree 3), then kept (they depend on nothing).
const ReferenceStress& referenceStress(int dim, int degree);

/// A cell's map from the reference simplex (vertices 0, e_1, .., e_dim), its sorted vertices in this order.
struct CellMap
{
  int dim = 0;                                                     ///< of space
  std::array<double, 9> F{}, /**< row-major, lengths */ inverse{}; ///< row-major
  double det = 0.0;                                                ///< |det F|
};

/// x = F xi + x_0 from the reference simplex onto a cell, vertices in sorted order.
CellMap cellMap(const Mesh& mesh, const SortedCell& cell);

/// Compliance of a law pulled back to the reference simplex: the entries c_m of ReferenceStress, upper triangle row by
/// row (shears in engineering form), divided by |det F|.
std::vector<double> pulledBackCompliance(const CellMap& map, const Elasticity& law);

/// A stress on one split cell as polynomials: for Check Equilibrium, for point values, for output.
struct SplitStress
{
  int dim = 0, /**< of space */ degree = 0; ///< q of the stress
  SortedCell cell;                          ///< its vertices
  CellMap map;                              ///< F and its determinant
  std::vector<double> coefficients;         ///< of S on the reference simplex
  /// sigma (Voigt) in sub-cell `sub` (the one without vertex `sub`) at barycentric coordinates lambda of the cell, in
  /// sorted order.
  void stress(int sub, const double* lambda, double* sigma) const;
  /// div sigma there.
  void divergence(int sub, const double* lambda, double* div) const;
  /// int sigma : C^-1 sigma over the cell, a sum of squares.
  double energy(const Elasticity& law) const;
};

} // namespace ndframe
