#pragma once

namespace ndframe
{

class KrylovLibrary;

/// The libraries of the Krylov solver, loaded at the first call (which only one thread may make). Throws InputError
/// when their module cannot be loaded.
const KrylovLibrary& krylovLibrary();

} // namespace ndframe
