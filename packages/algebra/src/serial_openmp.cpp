#include "serial_openmp.hpp"

#include <dlfcn.h>
#include <omp.h>

namespace ndframe
{

namespace
{

thread_local int serialScopes = 0;

} // namespace

SerialOpenMp::SerialOpenMp() : levelsBefore_(omp_get_max_active_levels())
{
  omp_set_max_active_levels(0);
  ++serialScopes;
}

SerialOpenMp::~SerialOpenMp()
{
  --serialScopes;
  omp_set_max_active_levels(levelsBefore_);
}

} // namespace ndframe

/// What compilers turn a parallel region into. Libraries find this one before libgomp's, which gets all regions that
/// are entered outside a SerialOpenMp.
extern "C" void GOMP_parallel(void (*region)(void*), void* data, unsigned numThreads, unsigned flags)
{
  if (ndframe::serialScopes > 0)
    return region(data);
  static const auto libgomp = reinterpret_cast<decltype(&GOMP_parallel)>(dlsym(RTLD_NEXT, "GOMP_parallel"));
  libgomp(region, data, numThreads, flags);
}
