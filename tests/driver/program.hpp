#pragma once

#include <string>
#include <vector>

namespace ndframe::test
{

/// What a call of the built ndframe left.
struct ProgramResult
{
  int exitCode = -1;
  std::string out, err;
};

/// The built ndframe.
std::string programPath();

/// Starts ndframe with these arguments in a folder and waits for it.
ProgramResult runProgram(const std::vector<std::string>& arguments, const std::string& folder,
                         const std::string& program = programPath());

std::string contentsOf(const std::string& path);
void writeFile(const std::string& path, const std::string& text);

/// `text` with the only occurrence of `from` replaced.
std::string replacedOnce(std::string text, const std::string& from, const std::string& to);

/// Names of the files in a folder, sorted.
std::vector<std::string> filesIn(const std::string& folder);

} // namespace ndframe::test
