#include "ndframe/algebra/library_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

#include <cblas.h>
#include <sys/mman.h>
#include <sys/resource.h>

/// What every routine of OpenBLAS calls first and last; not in its header.
extern "C" {
void* blas_memory_alloc(int unused);
void blas_memory_free(void* buffer);
}

namespace ndframe
{

namespace
{

/// OpenBLAS's buffer of a thread, with its alignment.
constexpr std::size_t blasBuffer = std::size_t(130) << 20;

/// Free memory of which another buffer is a small part. With less it is better left to the matrices.
constexpr std::size_t plenty = 8 * blasBuffer;

bool isLimited()
{
  rlimit addresses{}, data{};
  getrlimit(RLIMIT_AS, &addresses);
  getrlimit(RLIMIT_DATA, &data);
  return addresses.rlim_cur != RLIM_INFINITY || data.rlim_cur != RLIM_INFINITY;
}

bool isFree(std::size_t bytes)
{
  void* const place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED)
    return false;
  munmap(place, bytes);
  return true;
}

/// A product that is large enough for all threads: each takes its buffer, and keeps it.
void startBlas()
{
  constexpr int n = 192;
  const std::vector<double> A(std::size_t(n) * n, 1.0);
  std::vector<double> C(A.size());
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, A.data(), n, A.data(), n, 0.0, C.data(), n);
}

} // namespace

void claimLibraryMemory()
{
  if (!isLimited())
    return;
  if (!blasBuffersFit())
    throw std::bad_alloc();
  startBlas();
}

bool blasBuffersFit()
{
  return isFree(std::size_t(openblas_get_num_threads()) * blasBuffer);
}

int claimBlasBuffers(int wanted)
{
  if (!isLimited())
    return wanted;
  std::vector<void*> taken{blas_memory_alloc(0)};
  while (int(taken.size()) < wanted && isFree(plenty))
    taken.push_back(blas_memory_alloc(0));
  for (void* const buffer : taken)
    blas_memory_free(buffer); // to OpenBLAS's pool, not to the system
  return int(taken.size());
}

} // namespace ndframe
