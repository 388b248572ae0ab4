#include "ndframe/io/atomic_file.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <climits>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/progress.hpp"
#include "ndframe/base/scratch.hpp"

namespace ndframe
{
namespace
{

namespace fs = std::filesystem;

std::string reasonOf(int error)
{
  return std::generic_category().message(error);
}

/// What the temporary names of a target begin with on this machine: ".punch.e.HOST.", which a process number follows.
std::string temporaryPrefix(const fs::path& target)
{
  std::array<char, HOST_NAME_MAX + 1> host{};
  gethostname(host.data(), host.size() - 1);
  return fmt::format(".{}.{}.", target.filename().string(), host.data());
}

/// True when `name` is the temporary file of a process of this machine that is no more.
bool isStale(const std::string& name, const std::string& prefix)
{
  if (name.compare(0, prefix.size(), prefix) != 0)
    return false;
  pid_t process = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + prefix.size(), end, process);
  return error == std::errc() && std::string(rest, end) == ".tmp" && process > 0 && kill(process, 0) != 0 &&
         errno == ESRCH;
}

/// A process that was killed could not remove its temporary file.
void removeStale(const fs::path& folder, const std::string& prefix)
{
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
    if (isStale(entry->path().filename().string(), prefix))
      fs::remove(entry->path(), ignored);
}

/// The usual mistakes, found before any work is done. What remains shows when the file is opened.
void checkTarget(const fs::path& target, const fs::path& folder)
{
  std::error_code error;
  const auto folderStatus = fs::status(folder, error);
  if (folderStatus.type() == fs::file_type::not_found)
    throw InputError(fmt::format("cannot write \"{}\": the folder \"{}\" does not exist; create it or name another one",
                                 target.string(), folder.string()));
  if (!fs::is_directory(folderStatus))
    throw InputError(fmt::format("cannot write \"{}\": \"{}\" is not a folder{}", target.string(), folder.string(),
                                 error ? " (" + error.message() + ")" : ""));
  if (!target.has_filename() || fs::is_directory(target, error))
    throw InputError(fmt::format("cannot write \"{}\": it is a folder; name a file in it", target.string()));
  // Renaming onto a device or a pipe would replace it.
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    throw InputError(fmt::format("cannot write \"{}\": it is not a regular file", target.string()));
}

/// The folder of a target that may be replaced, without what killed processes left of it.
fs::path clearedFolder(const fs::path& target)
{
  fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  checkTarget(target, folder);
  removeStale(folder, temporaryPrefix(target));
  return folder;
}

void writeText(const std::string& path, const std::string& text)
{
  const auto close = [](std::FILE* file) { std::fclose(file); };
  std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "wb"), close);
  if (!file)
    throw std::runtime_error(reasonOf(errno));
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() || std::fflush(file.get()) != 0)
    throw std::runtime_error(reasonOf(errno));
  if (std::fclose(file.release()) != 0)
    throw std::runtime_error(reasonOf(errno));
}

} // namespace

void orCannotWrite(const std::string& path, const std::function<void()>& write)
{
  try {
    write();
  } catch (const InputError&) {
    throw;
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot write \"{}\": {}", path, error.code().message()));
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("cannot write \"{}\": {}", path, error.what()));
  }
}

PendingFile::PendingFile(std::string path, const std::function<void(const std::string&)>& write)
    : path_(std::move(path)),
      temporary_(clearedFolder(path_) / fmt::format("{}{}.tmp", temporaryPrefix(path_), getpid()))
{
  orCannotWrite(path_, [&] {
    write(temporary_.path().string());
    bytes_ = std::int64_t(fs::file_size(temporary_.path()));
  });
}

void PendingFile::keep()
{
  orCannotWrite(path_, [&] { fs::rename(temporary_.path(), path_); });
  noteWritten(path_);
}

std::int64_t writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write)
{
  PendingFile file(path, write);
  file.keep();
  return file.bytes();
}

std::int64_t writeTextAtomically(const std::string& path, const std::string& text)
{
  return writeAtomically(path, [&](const std::string& temporaryPath) { writeText(temporaryPath, text); });
}

std::size_t longestFileName()
{
  constexpr std::size_t longestProcessNumber = 10;
  return NAME_MAX - temporaryPrefix("").size() - longestProcessNumber - 4; // ".tmp"
}

void removeEarlier(const std::string& path)
{
  clearedFolder(path);
  std::error_code error;
  if (fs::remove(path, error); error)
    throw InputError(fmt::format("cannot remove \"{}\" of an earlier run: {}", path, error.message()));
}

} // namespace ndframe
