#pragma once

namespace ndframe
{

/// Where the process may take only so much memory (ulimit -v or -d), makes OpenBLAS take its buffers (128 MB a thread)
/// now; std::bad_alloc when they do not fit. Later, out of memory, it would try for ever. Does nothing without a limit.
void claimLibraryMemory();

/// True where memory is left for a buffer of each thread that OpenBLAS has started, which may not have taken it yet.
bool blasBuffersFit();

/// How many threads may call BLAS at the same time, at most `wanted`: each needs a buffer, which OpenBLAS has when this
/// returns. `wanted` without a limit; with one, as many more than 1 as leave plenty of memory (1 GB) for the matrices.
/// Call it while no other thread computes.
int claimBlasBuffers(int wanted);

} // namespace ndframe
