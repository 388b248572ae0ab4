#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// Contact in weighted means: fewer conditions than an interface has unknowns, one for each function of a space of
/// tractions, those that are continuous polynomials on the facets of one side as it was drawn (`Pairing/Type`: Mortar).
///
/// E has the coefficients of these functions at the unknowns, C is the mass matrix of the unknowns, and
///
///   W = (E^T C E)^-1 E^T C,   W E = 1:   the conditions  W [u] <= W g  with forces f <= 0,  W^T f at the unknowns.
///
/// So t = E (E^T C E)^-1 f has the nodal forces W^T f, and for displacements of the other side W is the P = C^-1 M of
/// mortar methods. Where every function belongs to one unknown, E and W are 1.
///
/// Source: Bernardi, Maday, Patera, A new nonconforming approach to domain decomposition, 1994; for contact Ben
/// Belgacem, Hild, Laborde, The mortar finite element method for contact problems, 1998.
class MortarSpace
{
public:
  /// functions: E, a row per unknown; means: W, a row per condition. Every condition belongs to the unknown at which
  /// its function is largest.
  MortarSpace(std::vector<SparseRow> functions, std::vector<SparseRow> means);

  int numConditions() const { return int(means_.size()); }             ///< of all interfaces
  const std::vector<SparseRow>& means() const { return means_; }       ///< W
  Vector meansOf(const Vector& unknowns) const;                        ///< W x
  Vector forcesOf(const Vector& unknowns) const;                       ///< E^T f: of forces W^T f those per condition
  Vector forcesAtUnknowns(const Vector& forces) const;                 ///< W^T f
  Vector valuesAtUnknowns(const Vector& coefficients) const;           ///< E c
  std::vector<char> statusesOf(const std::vector<char>& closed) const; ///< per condition from those of the unknowns
  /// Per unknown: closed where all functions are that are not zero there.
  std::vector<char> statusesAtUnknowns(const std::vector<char>& closed) const;

private:
  std::vector<SparseRow> functions_, means_;
  std::vector<int> unknownOf_; ///< per condition
};

} // namespace ndframe
