#include "ndframe/reading/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/memory.hpp"
#include "ndframe/reading/file_error.hpp"
#include "no_programs.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define NDFRAME_HAS_ADDRESS_SANITIZER 1 // its shadow memory does not fit under a limit
#else
#define NDFRAME_HAS_ADDRESS_SANITIZER 0
#endif

namespace ndframe
{

namespace
{

/// The first byte of an answer.
enum class Verdict : char
{
  Done = 'd',
  WrongFile = 'f',
  Failed = 'x'
};

// The status of a child that ends without an answer; the sanitizers have other ones.
constexpr int exitedStatus = 99; // its library called exit()
constexpr int unwatchedStatus = 97;
constexpr int noMemoryStatus = 98; // at once: the exception of a library's own thread would be a crash

void endWithoutMemory()
{
  _exit(noMemoryStatus);
}

class Pipe
{
public:
  Pipe()
  {
    if (pipe(ends_) != 0)
      throw InputError("no pipe to a child process can be made: too many files are open.");
  }
  ~Pipe()
  {
    closeEnd(0);
    closeEnd(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void closeEnd(int end)
  {
    if (ends_[end] >= 0)
      close(ends_[end]);
    ends_[end] = -1;
  }

  void write(const std::string& text) const
  {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t n = ::write(ends_[1], text.data() + done, text.size() - done);
      if (n < 0 && errno != EINTR)
        return; // the parent is gone
      done += n > 0 ? std::size_t(n) : 0;
    }
  }

  /// Everything until the other end is closed, or nothing when that takes more than so many seconds (0: no limit).
  std::optional<std::string> read(int seconds) const
  {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(seconds);
    std::string text;
    std::string block(std::size_t(1) << 16, '\0');
    for (ssize_t n = 1; n != 0;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      pollfd output{ends_[0], POLLIN, 0};
      if (seconds > 0 && poll(&output, 1, int(std::max<std::int64_t>(0, left))) == 0)
        return std::nullopt;
      n = ::read(ends_[0], block.data(), block.size());
      if (n < 0 && errno != EINTR)
        break;
      text.append(block, 0, n > 0 ? std::size_t(n) : 0);
    }
    return text;
  }

private:
  int ends_[2] = {-1, -1};
};

void lower(decltype(RLIMIT_AS) what, rlim_t value)
{
  rlimit limit{};
  getrlimit(what, &limit);
  limit.rlim_cur = std::min(limit.rlim_cur, value);
  setrlimit(what, &limit);
}

/// Some are blocked in the parent, where a thread waits for them, and METIS may have left handlers.
void acceptSignals()
{
  sigset_t none;
  sigemptyset(&none);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT})
    std::signal(signal, SIG_DFL);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void prepareChild(ChildLimits limits, pid_t parent)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(1); // it ended before that
  const int nowhere = open("/dev/null", O_RDWR);
  if (nowhere >= 0)
    dup2(nowhere, STDIN_FILENO); // a library that asks the user something would wait for ever
  if (nowhere >= 0 && !NDFRAME_HAS_ADDRESS_SANITIZER)
    dup2(nowhere, STDERR_FILENO); // the libraries' complaints come before the message that explains them
  // Of the handlers it runs first: the others, and the buffers, are the parent's.
  std::atexit([] { _exit(exitedStatus); });
  std::set_new_handler(endWithoutMemory);
  acceptSignals();
  if (limits.cpuSeconds > 0)
    lower(RLIMIT_CPU, rlim_t(limits.cpuSeconds));
  if (limits.extraBytes > 0 && !NDFRAME_HAS_ADDRESS_SANITIZER) {
    std::int64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    lower(RLIMIT_AS, rlim_t(pages * sysconf(_SC_PAGESIZE) + limits.extraBytes));
  }
  if (!limits.mayStartPrograms && !forbidPrograms())
    _exit(unwatchedStatus);
}

std::string answerOf(const std::function<std::string()>& work)
{
  const auto answer = [](Verdict verdict, const std::string& text) { return std::string(1, char(verdict)) + text; };
  try {
    return answer(Verdict::Done, work());
  } catch (const FileError& error) {
    return answer(Verdict::WrongFile, error.what());
  } catch (const std::bad_alloc&) { // a size beyond all bounds
    endWithoutMemory();
    return {};
  } catch (const std::exception& error) {
    return answer(Verdict::Failed, error.what());
  }
}

int waitFor(pid_t child)
{
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  return status;
}

[[noreturn]] void throwFailure(int status, const std::string& library)
{
  using Kind = ChildFailure::Kind;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const int exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  if (signal == SIGXCPU)
    throw ChildFailure(Kind::OutOfTime, fmt::format("{} did not finish on this file; it is damaged.", library));
  if (signal == SIGSYS)
    throw ChildFailure(Kind::StartsProgram, fmt::format("{} tried to start another program.", library));
  if (exitStatus == unwatchedStatus)
    throw ChildFailure(Kind::Unwatched,
                       fmt::format("this system has no way to keep {} from starting programs.", library));
  if (exitStatus == noMemoryStatus)
    throw ChildFailure(Kind::OutOfMemory, fmt::format("{} asks for more memory than the process may use.", library));
  if (exitStatus == exitedStatus)
    throw ChildFailure(Kind::Exited, fmt::format("{} failed on this file; it is damaged.", library));
  throw ChildFailure(Kind::Crashed, fmt::format("{} crashed on this file{}; it may be damaged.", library,
                                                signal > 0 ? fmt::format(" (signal {})", signal) : ""));
}

std::string resultOf(const std::string& answer, int status, const std::string& library)
{
  if (status != 0 || answer.empty())
    throwFailure(status, library);
  std::string text = answer.substr(1);
  switch (Verdict(answer.front())) {
  case Verdict::Done:
    return text;
  case Verdict::WrongFile:
    throw FileError(text);
  default:
    throw InternalError(text);
  }
}

} // namespace

std::int64_t freeMemory()
{
  const MemoryLeft left = memoryLeft();
  return left.limit.empty() ? 0 : left.bytes;
}

std::string runInChild(const std::function<std::string()>& work, const std::string& library, ChildLimits limits)
{
  Pipe pipe;
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0)
    throw InputError("no child process can be started to read a mesh: too many processes, or too little memory.");
  if (child == 0) {
    pipe.closeEnd(0);
    prepareChild(limits, parent);
    pipe.write(answerOf(work));
    _exit(0); // neither destructors nor buffers: they are the parent's
  }
  pipe.closeEnd(1);
  const auto answer = pipe.read(limits.wallSeconds);
  if (!answer) {
    kill(child, SIGKILL);
    waitFor(child);
    throw ChildFailure(ChildFailure::Kind::Waits, fmt::format("{} waits for something and has no result after {} s.",
                                                              library, limits.wallSeconds));
  }
  return resultOf(*answer, waitFor(child), library);
}

} // namespace ndframe
