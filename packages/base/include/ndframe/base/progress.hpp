#pragma once

#include <string>

namespace ndframe
{

// What this process is doing and which files it has finished: for the last words of a run that a signal ends. Any
// thread may call these functions.

/// A stage has begun ("factor"), or, empty, ended.
void noteStage(const std::string& stage);
/// A file stands complete under its name, or is gone again.
void noteWritten(const std::string& file);
void noteRemoved(const std::string& file); ///< takes noteWritten back

/// "interrupted by Ctrl-C (SIGINT) in the stage "factor"; complete files of this run: punch.study.partial.csv."
std::string lastWords(const std::string& cause);

} // namespace ndframe
