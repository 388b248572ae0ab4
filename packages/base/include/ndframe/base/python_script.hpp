#pragma once

#include <string>
#include <vector>

namespace ndframe
{

/// Debian's Python: the one that finds the modules of Debian's packages.
constexpr const char* pythonProgram = "/usr/bin/python3";

/// Exit code of runPython() when the program cannot be started.
constexpr int pythonNotStarted = 127;

/// Runs `/usr/bin/python3 -I -B ARGUMENTS...` and waits for it. The child ends with this process. Returns its exit
/// code, pythonNotStarted, or -1 when a signal ended it. `quiet`: what it prints on its standard output is dropped.
int runPython(const std::vector<std::string>& arguments, bool quiet);

} // namespace ndframe
