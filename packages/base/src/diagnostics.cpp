#include "ndframe/base/diagnostics.hpp"

#include <fmt/format.h>

namespace ndframe
{

namespace
{

std::string joinedText(const std::vector<Diagnostic>& list)
{
  std::string text;
  for (const auto& diagnostic : list)
    text += (text.empty() ? "" : "\n") + diagnostic.text();
  return text;
}

} // namespace

std::string Diagnostic::text() const
{
  const std::string where = line > 0 ? fmt::format("{}:{}: ", file, line) : file.empty() ? "" : file + ": ";
  return where + (path.empty() ? "" : path + ": ") + message;
}

void Diagnostics::add(Diagnostic diagnostic)
{
  list_.push_back(std::move(diagnostic));
}

void Diagnostics::append(const Diagnostics& other)
{
  list_.insert(list_.end(), other.list_.begin(), other.list_.end());
}

void Diagnostics::throwIfAny() const
{
  if (!list_.empty())
    throw InputError(list_);
}

InputError::InputError(std::vector<Diagnostic> list) : std::runtime_error(joinedText(list)), list_(std::move(list)) {}

void failAssertion(const char* condition, const std::string& message, const char* file, int line)
{
  throw InternalError(fmt::format("{}:{}: {} ({} does not hold)", file, line, message, condition));
}

} // namespace ndframe
