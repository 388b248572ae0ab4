#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ndframe
{

/// Walks through the text of a .msh file. Numbers are read as the file's encoding has them: words in ASCII, raw bytes
/// in binary. Everything that does not fit throws FileError with the line (ASCII) or the byte.
class MshCursor
{
public:
  explicit MshCursor(std::string_view text) : text_(text) {}

  void setBinary(bool binary) { binary_ = binary; }
  bool binary() const { return binary_; }

  /// Skips white space; true when nothing is left.
  bool atEnd();
  /// The rest of the line without its end, after leading white space.
  std::string_view line();
  /// Goes to the first byte of the next line and no further, where binary data begin.
  void endLine();
  /// Reads a word (always text) that must be `expected`.
  void expect(std::string_view expected);
  /// Goes behind the next line that is `marker`; false when there is none.
  bool skipBehindLine(const std::string& marker);

  /// A number written as a word, in binary files too (headers, physical names).
  std::int64_t wordInteger();
  double wordReal();
  /// A text in double quotes.
  std::string quoted();

  /// Numbers of the body: words, or 4-byte int, 8-byte size_t, 8-byte double.
  int int32();
  std::int64_t size();
  double real();
  /// The same as size(), for a number of things that take at least `bytesEach` bytes each (in ASCII two: a digit and a
  /// space): more than the rest of the file can hold is refused before anything is allocated.
  std::int64_t count(std::size_t bytesEach);
  /// Refuses a count that the rest of the file cannot hold.
  std::int64_t plausible(std::int64_t count, std::size_t bytesEach) const;

  [[noreturn]] void fail(const std::string& message) const;

private:
  std::string_view word();
  template <class T>
  T raw();
  std::size_t left() const { return text_.size() - position_; }

  std::string_view text_;
  std::size_t position_ = 0;
  bool binary_ = false;
};

} // namespace ndframe
