#define NDFRAME_LANES 2
#include "batched_kernels_impl.hpp"

namespace ndframe
{

extern const BatchedKernels portableKernels;
const BatchedKernels portableKernels = makeKernels("portable");

} // namespace ndframe
