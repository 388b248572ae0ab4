#include <cstddef>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>

/// Read by jemalloc before main: memory is asked for in pages of 2 MB where the kernel leaves that to programs, because
/// faults of small pages cost a third of a large run; and large blocks that are freed are kept for a while like small
/// ones, not given back at once only to be cleared again (0.7 instead of 1.0 s of the system for `punch` with 250 000
/// dofs). The environment's MALLOC_CONF can say otherwise.
extern "C" const char* malloc_conf;
const char* malloc_conf = "thp:always,oversize_threshold:0";

namespace
{

/// jemalloc ends without a word where it cannot begin, which is in the constructors of libraries.
void endWithoutMemory()
{
  constexpr std::size_t begin = std::size_t(48) << 20; // it, and what libraries take before main
  void* const room = mmap(nullptr, begin, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room != MAP_FAILED) {
    munmap(room, begin);
    return;
  }
  const char* const text =
      "ndframe: too little memory to begin with; raise the limit of the address space (ulimit -v)\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
  _exit(2);
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const beforeLibraries)() = endWithoutMemory;

} // namespace
