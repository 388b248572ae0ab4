#include "signals.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <future>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "ndframe/algebra/launcher.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/base/progress.hpp"
#include "ndframe/base/scratch.hpp"
#include "ndframe/live/transcript.hpp"

namespace ndframe
{

namespace
{

/// The signals that end a process, but for those that somebody wants ignored (nohup).
sigset_t endingSignals()
{
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_DFL)
      sigaddset(&signals, number);
  }
  return signals;
}

/// What was interrupted and what is there, from the first process only. With a write of its own: std::cerr may be in
/// the hands of a thread that does not let go of it.
void speakLast(int number)
{
  if (launcherOfThisProcess().rank != 0)
    return;
  const std::string newLine = isatty(STDERR_FILENO) != 0 ? "\n" : ""; // after "^C"
  const std::string cause = number == SIGINT    ? "interrupted by Ctrl-C (SIGINT)"
                            : number == SIGTERM ? "ended by SIGTERM"
                                                : "ended by SIGHUP, the terminal has gone";
  const std::string words = lastWords(cause), text = newLine + words + "\n";
  transcribe(words);
  if (write(STDERR_FILENO, text.data(), text.size()) < 0)
    return; // nobody reads it
}

[[noreturn]] void endByOneOf(const sigset_t& signals)
{
  int number = 0;
  while (sigwait(&signals, &number) != 0)
    ;
  removeScratch();
  speakLast(number);
  std::signal(number, SIG_DFL);
  raise(number); // to this thread, where it waits until it is let in
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  std::abort();
}

/// A thread waits for the signals, which no other one sees. A handler would not last: METIS puts its own in its place,
/// which jumps out of whatever METIS was doing last.
void watchSignals()
{
  const sigset_t signals = endingSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  endBlasThreads(); // they do not block them
  try {
    // It has to be up before this process forks: a thread that starts may hold locks that nobody frees in the child.
    const auto started = std::make_shared<std::promise<void>>();
    std::thread([signals, started] {
      started->set_value();
      endByOneOf(signals);
    }).detach();
    started->get_future().wait();
  } catch (const std::system_error&) { // too little memory: they end the process themselves
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
}

bool readerIsGone()
{
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

} // namespace

void prepareProcess()
{
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
      open("/dev/null", O_RDWR); // gets the lowest free number: this one
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  watchSignals();
}

const char* lostOutput()
{
  std::cout.flush();
  if (std::cout || readerIsGone())
    return nullptr;
  // The reason is not kept; an end of line more asks for it again.
  return write(STDOUT_FILENO, "\n", 1) < 0 ? std::strerror(errno) : "an earlier write failed";
}

} // namespace ndframe
