#include "msh_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

namespace
{

bool isSpace(char c)
{
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

} // namespace

bool MshCursor::atEnd()
{
  while (position_ < text_.size() && isSpace(text_[position_]))
    ++position_;
  return position_ == text_.size();
}

std::string_view MshCursor::word()
{
  if (atEnd())
    fail("the file ends too early");
  const std::size_t first = position_;
  while (position_ < text_.size() && !isSpace(text_[position_]))
    ++position_;
  return text_.substr(first, position_ - first);
}

std::string_view MshCursor::line()
{
  atEnd();
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  std::string_view found = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  while (!found.empty() && isSpace(found.back()))
    found.remove_suffix(1);
  return found;
}

void MshCursor::endLine()
{
  position_ = std::min(text_.find('\n', position_), text_.size() - 1) + 1;
}

void MshCursor::expect(std::string_view expected)
{
  atEnd();
  if (text_.substr(position_, expected.size()) != expected)
    fail(fmt::format("{} is expected here", expected));
  position_ += expected.size();
}

bool MshCursor::skipBehindLine(const std::string& marker)
{
  const std::size_t found = text_.find("\n" + marker, position_ > 0 ? position_ - 1 : 0);
  if (found == std::string_view::npos)
    return false;
  position_ = found + 1 + marker.size();
  return true;
}

std::int64_t MshCursor::wordInteger()
{
  const std::string_view w = word();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
  if (error != std::errc() || end != w.data() + w.size())
    fail(fmt::format("\"{:.20}\" is not an integer", w));
  return value;
}

double MshCursor::wordReal()
{
  const std::string_view w = word();
  double value = 0.0;
  const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
  if (error != std::errc() || end != w.data() + w.size() || !std::isfinite(value))
    fail(fmt::format("\"{:.20}\" is not a finite number", w));
  return value;
}

std::string MshCursor::quoted()
{
  expect("\"");
  const std::size_t end = text_.substr(0, text_.find('\n', position_)).find('"', position_);
  if (end == std::string_view::npos)
    fail("the name has no closing quote");
  const std::string_view name = text_.substr(position_, end - position_);
  position_ = end + 1;
  return std::string(name);
}

template <class T>
T MshCursor::raw()
{
  if (left() < sizeof(T))
    fail("the file ends too early");
  T value;
  std::memcpy(&value, text_.data() + position_, sizeof(T));
  position_ += sizeof(T);
  return value;
}

int MshCursor::int32()
{
  if (binary_)
    return raw<std::int32_t>();
  const std::int64_t value = wordInteger();
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    fail(fmt::format("{} is too large", value));
  return int(value);
}

std::int64_t MshCursor::size()
{
  const std::int64_t value = binary_ ? raw<std::int64_t>() : wordInteger();
  if (value < 0)
    fail(fmt::format("{} is negative or too large", value));
  return value;
}

double MshCursor::real()
{
  if (!binary_)
    return wordReal();
  const double value = raw<double>();
  if (!std::isfinite(value))
    fail("a coordinate is not finite");
  return value;
}

std::int64_t MshCursor::count(std::size_t bytesEach)
{
  return plausible(size(), bytesEach);
}

std::int64_t MshCursor::plausible(std::int64_t count, std::size_t bytesEach) const
{
  const std::size_t each = binary_ ? bytesEach : 2;
  if (count < 0 || std::size_t(count) > (left() + 1) / each)
    fail(fmt::format("a count of {} does not fit in the rest of the file", count));
  return count;
}

void MshCursor::fail(const std::string& message) const
{
  if (binary_)
    throw FileError(fmt::format("byte {}: {}.", position_, message));
  const auto lines = std::count(text_.begin(), text_.begin() + std::ptrdiff_t(std::min(position_, text_.size())), '\n');
  throw FileError(fmt::format("line {}: {}.", lines + 1, message));
}

} // namespace ndframe
