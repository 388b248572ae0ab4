#include "driver/program.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/wait.h>

#include <gtest/gtest.h>

#include "io/temporary_folder.hpp"

namespace ndframe::test
{
namespace
{

std::string quoted(const std::string& text)
{
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

} // namespace

std::string programPath()
{
  return NDFRAME_PROGRAM;
}

ProgramResult runProgram(const std::vector<std::string>& arguments, const std::string& folder,
                         const std::string& program)
{
  const TemporaryFolder streams;
  std::string command = "cd " + quoted(folder) + " && " + quoted(program);
  for (const auto& argument : arguments)
    command += " " + quoted(argument);
  command += " >" + quoted(streams.file("out")) + " 2>" + quoted(streams.file("err"));
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status)) << "ended by a signal: " << command;
  return {WEXITSTATUS(status), contentsOf(streams.file("out")), contentsOf(streams.file("err"))};
}

std::string contentsOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void writeFile(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

std::string replacedOnce(std::string text, const std::string& from, const std::string& to)
{
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "there is no " << from;
  EXPECT_EQ(text.find(from, at + 1), std::string::npos) << "there is more than one " << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::vector<std::string> filesIn(const std::string& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace ndframe::test
