#include "exodus_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <dlfcn.h>
#include <fmt/format.h>

namespace ndframe
{

namespace
{

bool isOfTheDisk(int error)
{
  return error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO;
}

} // namespace

ExodusFile::ExodusFile(const std::string& path)
{
  int memoryWordSize = sizeof(double);
  int fileWordSize = sizeof(double);
  errno = 0;
  id_ = ex_create(path.c_str(), EX_CLOBBER | EX_LARGE_MODEL, &memoryWordSize, &fileWordSize);
  check(std::min(id_, 0), "the file");
}

ExodusFile ExodusFile::opened(const std::string& path)
{
  int memoryWordSize = sizeof(double);
  int fileWordSize = sizeof(double);
  float version = 0.0F;
  errno = 0;
  const int id = ex_open(path.c_str(), EX_WRITE, &memoryWordSize, &fileWordSize, &version);
  check(std::min(id, 0), "to the file");
  return ExodusFile(id);
}

ExodusFile::~ExodusFile()
{
  if (id_ >= 0)
    ex_close(id_);
}

void ExodusFile::close()
{
  const int id = id_;
  id_ = -1;
  errno = 0;
  check(ex_close(id), "the end of the file");
}

void ExodusFile::check(int status, const char* what)
{
  const int lastError = errno;
  if (status == 0)
    return;
  const char* message = "";
  const char* function = "";
  int code = 0;
  ex_get_err(&message, &function, &code);
  // Positive codes are the system's. Sometimes the library forgets that the disk was full, and complains of what
  // followed.
  const int reason = code > 0 ? code : isOfTheDisk(lastError) ? lastError : 0;
  throw std::runtime_error(
      reason > 0 ? fmt::format("Exodus could not write {}: {}", what, std::strerror(reason))
                 : fmt::format("Exodus could not write {}: {} ({}, code {})", what, message, function, code));
}

CStrings::CStrings(std::vector<std::string> texts) : texts_(std::move(texts))
{
  for (auto& text : texts_)
    pointers_.push_back(text.data());
}

std::string headOf(const std::string& text, std::size_t bytes)
{
  if (text.size() <= bytes)
    return text;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  auto end = bytes;
  while (end > 0 && continues(text[end]))
    --end;
  return text.substr(0, end > 0 ? end : bytes);
}

std::vector<std::string> wrapInfoLines(const std::vector<std::string>& lines)
{
  std::vector<std::string> records;
  for (auto rest : lines) {
    while (rest.size() > MAX_LINE_LENGTH) {
      const auto head = headOf(rest, MAX_LINE_LENGTH - 1);
      records.push_back(head + '\\');
      rest.erase(0, head.size());
    }
    records.push_back(rest);
  }
  return records;
}

} // namespace ndframe

/// What Exodus creates its files with. It finds this one before netCDF's, whose buffer of 8 KB costs a system call for
/// each 160 bytes of results (netCDF goes through all pages for every variable) and which Exodus cannot be told to
/// enlarge.
extern "C" int nc_create(const char* path, int mode, int* id)
{
  static const auto create =
      reinterpret_cast<int (*)(const char*, int, std::size_t, std::size_t*, int*)>(dlsym(RTLD_DEFAULT, "nc__create"));
  std::size_t bufferSize = std::size_t(1) << 20;
  return create(path, mode, 0, &bufferSize, id);
}

/// What Exodus opens files with, shared with others (NC_SHARE): then netCDF writes without a buffer, and forgets when
/// the disk is full.
extern "C" int nc_open(const char* path, int mode, int* id)
{
  constexpr int isWritten = 0x1, isShared = 0x800; // NC_WRITE, NC_SHARE
  static const auto open =
      reinterpret_cast<int (*)(const char*, int, std::size_t*, int*)>(dlsym(RTLD_DEFAULT, "nc__open"));
  std::size_t bufferSize = (mode & isWritten) != 0 ? std::size_t(1) << 20 : 0; // 0: as netCDF likes
  return open(path, mode & ~isShared, &bufferSize, id);
}
