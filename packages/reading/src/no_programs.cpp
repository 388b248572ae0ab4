#include "no_programs.hpp"

#include <array>
#include <cerrno>
#include <cstddef>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

namespace ndframe
{
namespace
{

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0; // no filter
#endif

#if defined(SYS_fork)
constexpr unsigned forkCall = SYS_fork, vforkCall = SYS_vfork;
#else // made of clone
constexpr unsigned forkCall = SYS_clone3, vforkCall = SYS_clone3;
#endif

/// Calls of x86-64's other interface (x32) have this bit.
constexpr unsigned otherInterface = 0x40000000;

sock_filter load(std::size_t offset)
{
  return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, unsigned(offset));
}

sock_filter answer(unsigned action)
{
  return BPF_STMT(BPF_RET | BPF_K, action);
}

/// Skips so many of the next lines if the comparison holds, or does not.
sock_filter skip(unsigned short comparison, unsigned value, unsigned char ifTrue, unsigned char ifFalse)
{
  return BPF_JUMP(static_cast<unsigned short>(BPF_JMP | comparison | BPF_K), value, ifTrue, ifFalse);
}

} // namespace

bool forbidPrograms()
{
  if (architecture == 0)
    return false;
  // glibc starts threads by clone3, whose flags a filter cannot see, and by clone where the kernel has no clone3.
  std::array<sock_filter, 15> lines{
      load(offsetof(seccomp_data, arch)), skip(BPF_JEQ, architecture, 0, 12),   // else: end
      load(offsetof(seccomp_data, nr)),   skip(BPF_JGE, otherInterface, 10, 0), // end
      skip(BPF_JEQ, SYS_clone3, 5, 0),                                          // deny
      skip(BPF_JEQ, forkCall, 8, 0),                                            // end
      skip(BPF_JEQ, vforkCall, 7, 0),                                           // end
      skip(BPF_JEQ, SYS_execve, 6, 0),                                          // end
      skip(BPF_JEQ, SYS_execveat, 5, 0),                                        // end
      skip(BPF_JEQ, SYS_clone, 1, 3),                                           // flags, else allow
      answer(SECCOMP_RET_ERRNO | ENOSYS),                                       // deny
      load(offsetof(seccomp_data, args)), // flags, the lower half on these machines
      skip(BPF_JSET, CLONE_THREAD, 0, 1), // allow, else end
      answer(SECCOMP_RET_ALLOW),
      answer(SECCOMP_RET_KILL_PROCESS), // end
  };
  const sock_fprog program{static_cast<unsigned short>(lines.size()), lines.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

} // namespace ndframe
