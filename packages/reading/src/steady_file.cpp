#include "ndframe/reading/steady_file.hpp"

#include <fstream>
#include <sstream>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

SteadyFile::SteadyFile(const std::string& path) : path_(path), before_(stamp())
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status))
    throw FileError("this is a directory, not a file.");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw FileError("this is not a regular file.");
}

SteadyFile::Stamp SteadyFile::stamp() const
{
  std::error_code ignored;
  return {std::filesystem::file_size(path_, ignored), std::filesystem::last_write_time(path_, ignored)};
}

void SteadyFile::requireUnchanged() const
{
  const Stamp now = stamp();
  if (now.size != before_.size || now.written != before_.written)
    throw FileError("the file changed while it was read; try again when it is complete.");
}

std::string readText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream)
    throw FileError("the file cannot be read; relative paths start from the deck's folder.");
  return std::move(text).str();
}

} // namespace ndframe
