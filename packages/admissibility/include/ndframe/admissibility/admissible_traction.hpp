#pragma once

#include <stdexcept>
#include <string>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/algebra/sparse_columns.hpp"

namespace ndframe
{

/// What tractions must do for a body that its supports do not hold: work against every free motion,
///   sum_patches +- int t_N (motion . n_c) = - (loads' work),   one row a motion (the Remark of section 5.3).
/// The motions move the bodies by about 1 (RigidBasis), so that work is a force.
struct BalanceConditions
{
  SparseColumns work; ///< interface nodes x conditions: int psi_i motion . n_c with the body's sign
  Vector value;       ///< per condition
  /// Per condition the sum of the loads' absolute contributions: what the round-off of `value` is compared with. Empty:
  /// the values themselves.
  Vector magnitude;
  std::vector<std::string> names; ///< "translation along y of punch", for messages
};

/// What a traction that presses everywhere has to show.
enum class TractionSign
{
  Coefficients, ///< Bernstein coefficients <= 0 on every patch: more than is needed, kept by every later step
  Values        ///< t_N <= 0 at the nodes, as the paper asks: a quadratic may still pull between them
};

/// Section 5.3: the traction with nodal values nearest in L2 to `mean` that presses everywhere and balances the loads
/// of floating bodies.
///
/// A strictly convex quadratic program, solved exactly by block principal pivoting on banded factors (Judice and Pires;
/// Kim and Park 2011) that falls back on Murty's single pivots (finite). KKT conditions hold to 1e-12 relative.
/// Throws InfeasibleTraction when no t_N <= 0 balances the loads (a floating body is pulled).
/// mean, result: per interface node. order: 1 or 2.
/// cost: what a unit nodal value costs beside half the squared distance (per node; empty: nothing). Where bodies are
/// apart it keeps tractions away that balance would put there.
Vector projectTraction(const std::vector<ContactPatch>& patches, int numNodes, int order, const Vector& mean,
                       const BalanceConditions& balance, TractionSign sign = TractionSign::Coefficients,
                       const Vector& cost = {});

/// No t_N <= 0 balances the loads.
class InfeasibleTraction : public std::runtime_error
{
public:
  /// along: as `motion`.
  explicit InfeasibleTraction(const std::string& along)
      : std::runtime_error("no compressive traction balances the loads along " + along), motion(along)
  {}
  std::string motion; ///< along which the loads pull: names of the conditions, joined by "and"
};

} // namespace ndframe
