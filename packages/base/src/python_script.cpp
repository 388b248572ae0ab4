#include "ndframe/base/python_script.hpp"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ndframe
{

int runPython(const std::vector<std::string>& arguments, bool quiet)
{
  std::vector<std::string> texts{pythonProgram, "-I",
                                 "-B"}; // the user's modules and folders have no say; no .pyc files
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  for (std::string& text : texts)
    words.push_back(text.data());
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (const int nowhere = quiet ? open("/dev/null", O_WRONLY) : -1; nowhere >= 0)
      dup2(nowhere, STDOUT_FILENO);
    execv(words.front(), words.data());
    _exit(pythonNotStarted);
  }
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace ndframe
