#pragma once

#include "krylov_library.hpp"

namespace ndframe
{

/// The choices of "Preconditioner". Their parameters are checked, and they are built, by the module's libraries.
Registry<Preconditioner> preconditioners();

} // namespace ndframe
