#include "krylov_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

namespace
{

const KrylovLibrary* loadedLibrary = nullptr;

const KrylovLibrary* load()
{
  void* const module = dlopen(NDFRAME_KRYLOV_MODULE, RTLD_NOW | RTLD_LOCAL);
  if (!module)
    throw InputError(
        fmt::format("the linear solver Krylov needs the module {} in {} of the folder that ndframe is installed in, "
                    "and it cannot be loaded ({}); install all of ndframe, or use another linear solver.",
                    NDFRAME_KRYLOV_MODULE, NDFRAME_MODULE_DIR, dlerror()));
  void* const entry = dlsym(module, "ndframeKrylovLibrary");
  NDFRAME_ASSERT(entry, NDFRAME_KRYLOV_MODULE " has no entry");
  return reinterpret_cast<const KrylovLibrary* (*)()>(entry)();
}

} // namespace

const KrylovLibrary& krylovLibrary()
{
  if (!loadedLibrary) {
    loadedLibrary = load();
    beforeMpiEnds([] { loadedLibrary->finish(); });
  }
  return *loadedLibrary;
}

} // namespace ndframe
