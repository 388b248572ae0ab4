#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// The Neumann problem (25) condensed to the interface:  S2 u2_N = g2 - C Lambda.
///
/// The minus is the paper's -t_neu of (52): body 2 receives the opposite of the traction on body 1. A floating body has
/// a solution only if its loads and the traction balance, R^T (g2 - C Lambda) = 0 for the traces R of its free motions,
/// and then many: u2_N + R alpha. The one returned vanishes at as many nodes as there are motions.
class NeumannProblem
{
public:
  /// S must outlive the problem; g: reduced load of the Neumann bodies (force per interface unknown); rigidTraces:
  /// S.size() x modes, normal displacements of the motions that the supports leave free (no columns: S is regular).
  /// held: entries that are given, of no interest to S (obstacles of the Dirichlet bodies); their solution is zero.
  NeumannProblem(const SymmetricOperator& S, Vector g, const DenseMatrix& rigidTraces, Ledger& ledger,
                 const std::vector<char>& held = {});

  /// u2_N under the nodal contact forces r = C Lambda (negative in compression).
  Vector solve(const Vector& contactForce) const;

private:
  Vector g_;
  std::unique_ptr<RestrictedInverse> inverse_;
  Ledger& ledger_;
};

/// Flags of the entries that stay free when as many entries are held as there are motions, so that every motion is
/// stopped: the held ones are the pivots of an orthogonalisation of the motions' traces (rows: entries). Those that are
/// held anyway must have no trace.
std::vector<char> freeWhenHeld(const DenseMatrix& rigidTraces, const std::vector<char>& held = {});

} // namespace ndframe
