#include "kokkos_runtime.hpp"

#include <Kokkos_Core.hpp>

namespace ndframe
{

void startKokkos()
{
  if (Kokkos::is_initialized())
    return;
  Kokkos::InitArguments arguments;
  arguments.disable_warnings = true;
  Kokkos::initialize(arguments);
}

void finishKokkos()
{
  if (Kokkos::is_initialized())
    Kokkos::finalize();
}

} // namespace ndframe
