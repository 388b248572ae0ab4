#pragma once

#include <functional>

#include "ndframe/iterative/krylov_library.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

/// A matrix and its preconditioner; `work` of the latter, if it counts.
struct PreconditionedMatrix
{
  Teuchos::RCP<const TpetraOperator> matrix;
  Teuchos::RCP<const TpetraOperator> preconditioner;
  std::function<CycleWork()> work = {};
};

/// Belos's pseudo-block conjugate gradients. `list`: parameters of the solver, conformed to the valid ones.
std::unique_ptr<ConjugateGradients> makeBelosCg(PreconditionedMatrix system, const Teuchos::ParameterList& list);

const Teuchos::ParameterList& validBelosList();

} // namespace ndframe
