#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <sys/mman.h>
#include <unistd.h>

/// Read by jemalloc before main: memory is asked for in pages of 2 MB where the kernel leaves that to programs, because
/// faults of small pages cost a third of a large run. Large blocks that are freed are kept for a while like small ones,
/// not given back at once only to be cleared again (0.76 instead of 0.98 s of the system for `punch` with 250 000
/// dofs), and for half a minute instead of ten seconds, which takes no more memory at the peak of a run with a target.
/// Where several processes are started, what each keeps adds up: 30 MB that stay empty in such pages, and 15 of 180 MB
/// that the set-up of a multigrid has freed. There blocks of 8 MB are given back at once, others within a second: with
/// 1 MB and 20 ms four processes of a million dofs took a tenth more processor time and 8 of 440 MB less.
/// The environment's MALLOC_CONF can say otherwise.
extern "C" const char* malloc_conf;
const char* malloc_conf = "thp:always,oversize_threshold:0,dirty_decay_ms:30000";

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

/// "NAME=1" is one process, too. The names are those of launcher.cpp (package algebra).
bool isOneOfSeveral(char** environment)
{
  for (; *environment != nullptr; ++environment)
    for (const char* name : {"OMPI_COMM_WORLD_SIZE=", "PMI_SIZE=", "MV2_COMM_WORLD_SIZE=", "SLURM_STEP_NUM_TASKS="})
      if (std::strncmp(*environment, name, std::strlen(name)) == 0 &&
          std::strcmp(*environment + std::strlen(name), "1") != 0)
        return true;
  return false;
}

void begin(int, char**, char** environment)
{
  endWithoutMemory();
  if (isOneOfSeveral(environment))
    malloc_conf = "thp:default,oversize_threshold:8388608,dirty_decay_ms:1000";
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const beforeLibraries)(int, char**, char**) = begin;

} // namespace
