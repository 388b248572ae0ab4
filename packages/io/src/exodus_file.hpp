#pragma once

#include <cerrno>
#include <string>
#include <vector>

#include <exodusII.h>

namespace ndframe
{

/// An Exodus file open for writing (NetCDF-3 with 64-bit offsets, double precision). Closed at the latest by the
/// destructor.
class ExodusFile
{
public:
  explicit ExodusFile(const std::string& path);
  /// One that is there, to add values to.
  static ExodusFile opened(const std::string& path);
  ~ExodusFile();
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  /// Calls `function(id, arguments...)` and throws std::runtime_error with the library's reason unless it returns
  /// 0: a warning means that something was left out.
  template <class Function, class... Arguments>
  void call(const char* what, Function function, Arguments... arguments)
  {
    errno = 0;
    check(function(id_, arguments...), what);
  }
  /// Writes what is still buffered, e.g. onto a disk that may be full: its result matters.
  void close();

private:
  explicit ExodusFile(int id) : id_(id) {}
  static void check(int status, const char* what);
  int id_ = -1;
};

/// What the library's `char*[]` arguments want; lives as long as this object.
class CStrings
{
public:
  explicit CStrings(std::vector<std::string> texts);
  CStrings(const CStrings&) = delete;
  CStrings& operator=(const CStrings&) = delete;
  char** data() { return pointers_.data(); }
  int size() const { return int(pointers_.size()); }

private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

/// The first `bytes` bytes of a text or a little less, so that no UTF-8 character is cut in two.
std::string headOf(const std::string& text, std::size_t bytes);

/// Information records hold 80 characters. A longer line goes on in the next record, after a backslash.
std::vector<std::string> wrapInfoLines(const std::vector<std::string>& lines);

} // namespace ndframe
