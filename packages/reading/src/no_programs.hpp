#pragma once

namespace ndframe
{

/// From here on this process, which must have one thread, can start threads but no other process: an attempt ends it by
/// SIGSYS (fork, vfork, clone without a thread, execve). A filter of the kernel (seccomp) watches, so that it does not
/// matter how a library is talked into it. False where the kernel offers none.
bool forbidPrograms();

} // namespace ndframe
