#pragma once

#include "krylov_library.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

/// Belos's pseudo-block conjugate gradients. `list`: parameters of the solver, conformed to the valid ones.
std::unique_ptr<ConjugateGradients> makeBelosCg(TpetraSystem system, const Preconditioner& preconditioner,
                                                const Teuchos::ParameterList& list);

const Teuchos::ParameterList& validBelosList();

} // namespace ndframe
