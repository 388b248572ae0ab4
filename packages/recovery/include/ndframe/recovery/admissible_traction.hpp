#pragma once

#include <string>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/recovery/contact_traction.hpp"

namespace ndframe
{

/// What tractions must do for a body that its supports do not hold: work against every free motion,
///   sum_facets +- int t_N (motion . n_c) = - (loads' work),   one row a motion (the Remark of section 5.3).
/// The motions move the bodies by about 1 (RigidBasis), so that work is a force.
struct BalanceConditions
{
  DenseMatrix work; ///< conditions x interface nodes: int psi_i motion . n_c with the body's sign
  Vector value;     ///< per condition
  /// Per condition the sum of the loads' absolute contributions: what the round-off of `value` is compared with. Empty:
  /// the values themselves.
  Vector magnitude;
  std::vector<std::string> names; ///< "translation along y of punch", for messages
};

/// Section 5.3: the traction with nodal values nearest in L2 to `mean`, whose Bernstein coefficients are <= 0 on every
/// facet and which balances the loads of floating bodies.
///
/// A strictly convex quadratic program, solved exactly by block principal pivoting on banded factors (Judice and Pires;
/// Kim and Park 2011) that falls back on Murty's single pivots (finite). KKT conditions hold to 1e-12 relative.
/// Throws InfeasibleTraction when no t_N <= 0 balances the loads (a floating body is pulled).
/// mean, result: per interface node. order: 1 or 2.
Vector projectTraction(const std::vector<ContactFacet>& facets, int numNodes, int order, const Vector& mean,
                       const BalanceConditions& balance);

struct InfeasibleTraction
{
  std::string motion; ///< along which the loads pull: names of the conditions, joined by "and"
};

} // namespace ndframe
