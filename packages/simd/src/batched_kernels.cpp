#include "batched_workspace.hpp"

namespace ndframe
{

// Each defined in a translation unit compiled for its instruction set.
extern const BatchedKernels portableKernels, avx2Kernels, avx512Kernels;

std::vector<const BatchedKernels*> availableKernels()
{
  std::vector<const BatchedKernels*> kernels{&portableKernels};
#ifdef NDFRAME_X86_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    kernels.push_back(&avx2Kernels);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    kernels.push_back(&avx512Kernels);
#endif
  return kernels;
}

} // namespace ndframe
