#pragma once

namespace ndframe
{

/// Starts Kokkos on first need (Tpetra would start it too, but warn about what it does not find).
void startKokkos();

/// Ends Kokkos if it was started. No Tpetra object may be alive.
void finishKokkos();

} // namespace ndframe
