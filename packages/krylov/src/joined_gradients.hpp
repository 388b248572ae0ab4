#pragma once

#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

std::unique_ptr<JoinedGradients> makeJoinedGradients(const JoinedBodies& bodies, const JoinedUnknowns& unknowns,
                                                     const Comm& comm, std::shared_ptr<const Preconditioner> coarse,
                                                     const Teuchos::ParameterList& belos);

} // namespace ndframe
