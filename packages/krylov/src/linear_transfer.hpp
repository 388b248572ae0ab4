#pragma once

#include <array>

#include <Tpetra_Import.hpp>

#include "ndframe/algebra/linear_level.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

/// P and P^T between the interior dofs of a body and those of its vertices, as this rank's nodes need them. Vectors are
/// zero elsewhere.
class LinearTransfer
{
public:
  LinearTransfer(const SolverProblem& fine, const LinearLevel& level, Teuchos::RCP<const TpetraMap> coarseMap);

  /// coarse = P^T fine
  void toCoarse(const double* fine, TpetraVectors& coarse);
  /// fine = P coarse; what does not belong to an interior dof is set to zero in `coarse`, too
  void toFine(TpetraVectors& coarse, double* fine);

private:
  void annul(TpetraVectors& coarse) const;
  template <class Action>
  void eachEnd(const Action& action) const;

  int dim_;
  std::vector<std::array<int, 2>> ends_; ///< per own node, vertices as this rank numbers them
  std::vector<int> turned_;              ///< per own node its place in blocks_, -1: none; empty: none at all
  std::vector<double> blocks_;
  std::vector<std::size_t> held_, coarseHeld_; ///< own dofs that are not interior
  Teuchos::RCP<const Tpetra::Import<>> import_;
  Teuchos::RCP<TpetraVectors> seen_; ///< of the vertices that this rank needs
};

} // namespace ndframe
