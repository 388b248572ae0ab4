#include "serial_openmp.hpp"

#include <dlfcn.h>
#include <omp.h>

namespace ndframe
{

namespace
{

thread_local int serialScopes = 0;
thread_local const std::function<void()>* observer = nullptr; ///< of the innermost scope

} // namespace

SerialOpenMp::SerialOpenMp(std::function<void()> onRegion)
    : levelsBefore_(omp_get_max_active_levels()), onRegion_(std::move(onRegion)), observerBefore_(observer)
{
  omp_set_max_active_levels(0);
  ++serialScopes;
  observer = onRegion_ ? &onRegion_ : nullptr;
}

SerialOpenMp::~SerialOpenMp()
{
  --serialScopes;
  observer = observerBefore_;
  omp_set_max_active_levels(levelsBefore_);
}

} // namespace ndframe

/// What compilers turn a parallel region into. Libraries find this one before libgomp's, which gets all regions that
/// are entered outside a SerialOpenMp.
extern "C" void GOMP_parallel(void (*region)(void*), void* data, unsigned numThreads, unsigned flags)
{
  if (ndframe::serialScopes > 0) {
    region(data);
    if (ndframe::observer != nullptr)
      (*ndframe::observer)();
    return;
  }
  static const auto libgomp = reinterpret_cast<decltype(&GOMP_parallel)>(dlsym(RTLD_NEXT, "GOMP_parallel"));
  libgomp(region, data, numThreads, flags);
}
