#pragma once

#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

/// The choices of "Preconditioner". Their parameters are checked, and they are built, by the module's libraries.
Registry<Preconditioner> preconditioners();

/// The list "MueLu" of a component, handed on to the library.
ListSpec mueLuList();

/// MueLu for the vertices of second-order elements: a smoother of degree 4, unless the list says otherwise. There it is
/// cheap beside what is done on all nodes.
std::unique_ptr<Preconditioner> makeVertexMueLu(const Teuchos::ParameterList& list);

} // namespace ndframe
