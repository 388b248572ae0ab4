#define NDFRAME_LANES 8
#include "batched_kernels_impl.hpp"

namespace ndframe
{

extern const BatchedKernels avx512Kernels;
const BatchedKernels avx512Kernels = makeKernels("avx512");

} // namespace ndframe
