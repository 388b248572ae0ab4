#pragma once

/// Heavy header: only for the translation units that talk to Tpetra, Belos, MueLu or Ifpack2.

#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

using TpetraMap = Tpetra::Map<>;
using TpetraMatrix = Tpetra::CrsMatrix<double>;
using TpetraVectors = Tpetra::MultiVector<double>;
using TpetraOperator = Tpetra::Operator<double>;

/// The interior problem as Tpetra sees it. Fixed and kept dofs stay as decoupled rows with a typical diagonal entry, so
/// that every node keeps its dim rows side by side:
///
///   A = [ K_ii  0   ]
///       [ 0     a I ],   a = decoupledDiagonal.
///
/// Each rank holds the rows of its nodes.
struct TpetraSystem
{
  TpetraSystem(const RankProblem& problem, const Comm& comm, double decoupledDiagonal);

  int dim;
  bool isParallel;
  Teuchos::RCP<const TpetraMap> dofMap;
  Teuchos::RCP<TpetraMatrix> matrix;
  Teuchos::RCP<TpetraVectors> modes;       ///< near null space; null without modes
  Teuchos::RCP<TpetraVectors> coordinates; ///< one row per node; null without points
};

/// Wraps what a preconditioner's builder returns, so that headers without Tpetra can name it.
struct PreconditionerHandle
{
  Teuchos::RCP<TpetraOperator> apply;
  Traffic traffic = {}; ///< of this rank when it is applied once, where that is known
};

} // namespace ndframe
