#include "ndframe/io/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

namespace fs = std::filesystem;

std::string reasonOf(int error)
{
  return std::generic_category().message(error);
}

/// Removes the temporary file unless it has been renamed.
class TemporaryFile
{
public:
  explicit TemporaryFile(const fs::path& target)
      : path_(target.parent_path() / fmt::format(".{}.{}.tmp", target.filename().string(), getpid()))
  {}
  ~TemporaryFile()
  {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_.string(); }
  void renameTo(const fs::path& target) const { fs::rename(path_, target); }
  std::int64_t size() const { return std::int64_t(fs::file_size(path_)); }

private:
  fs::path path_;
};

/// The usual mistakes, found before any work is done. What remains shows when the file is opened.
void checkTarget(const fs::path& target)
{
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
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

std::int64_t writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write)
{
  const fs::path target(path);
  checkTarget(target);
  const TemporaryFile temporary(target);
  try {
    write(temporary.path());
    const auto bytes = temporary.size();
    temporary.renameTo(target);
    return bytes;
  } catch (const InputError&) {
    throw;
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot write \"{}\": {}", path, error.code().message()));
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("cannot write \"{}\": {}", path, error.what()));
  }
}

std::int64_t writeTextAtomically(const std::string& path, const std::string& text)
{
  return writeAtomically(path, [&](const std::string& temporaryPath) { writeText(temporaryPath, text); });
}

} // namespace ndframe
