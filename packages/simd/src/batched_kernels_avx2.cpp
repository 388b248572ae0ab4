#define NDFRAME_LANES 4
#include "batched_kernels_impl.hpp"

namespace ndframe
{

extern const BatchedKernels avx2Kernels;
const BatchedKernels avx2Kernels = makeKernels("avx2");

} // namespace ndframe
