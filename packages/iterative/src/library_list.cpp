#include "library_list.hpp"

#include <algorithm>

#include <Teuchos_ParameterList.hpp>
#include <fmt/format.h>

#include "ndframe/base/help.hpp"

namespace ndframe
{

namespace
{

std::vector<std::string> keysOf(const Teuchos::ParameterList& list)
{
  std::vector<std::string> keys;
  for (const auto& item : list)
    keys.push_back(item.first);
  return keys;
}

bool isIntForDouble(const Teuchos::ParameterEntry& given, const Teuchos::ParameterEntry& valid)
{
  return given.isType<int>() && valid.isType<double>();
}

std::string unknownKey(const std::string& key, const Teuchos::ParameterList& valid, const std::string& library)
{
  const std::string nearest = nearestName(key, keysOf(valid));
  return fmt::format("\"{}\" is not a parameter of {}{}", key, library,
                     nearest.empty() ? "." : fmt::format("; did you mean \"{}\"?", nearest));
}

/// The library's own verdict on a value of a known key: empty, or the reason to refuse it.
std::string wrongValue(const std::string& key, const Teuchos::ParameterEntry& given,
                       const Teuchos::ParameterEntry& valid, const std::string& library)
{
  if (given.isList() || valid.isList()) // libraries describe their sublists too loosely to check them here
    return given.isList() == valid.isList()
               ? ""
               : fmt::format("\"{}\" of {} {} a list.", key, library, valid.isList() ? "must be" : "is not");
  if (isIntForDouble(given, valid))
    return {};
  if (given.getAny(false).typeName() != valid.getAny(false).typeName())
    return fmt::format("\"{}\" of {} must be of type {}, not {}.", key, library, valid.getAny(false).typeName(),
                       given.getAny(false).typeName());
  try {
    if (!Teuchos::is_null(valid.validator()))
      valid.validator()->validate(given, key, library);
    return {};
  } catch (const std::exception&) {
    const auto strings = valid.validator()->validStringValues();
    return fmt::format("\"{}\" of {} cannot be {}{}", key, library, Teuchos::toString(given.getAny(false)),
                       Teuchos::is_null(strings) ? "." : fmt::format("; use one of: {}.", fmt::join(*strings, ", ")));
  }
}

} // namespace

std::vector<std::string> mistakesIn(const Teuchos::ParameterList& given, const Teuchos::ParameterList& valid,
                                    const std::string& library, const std::vector<std::string>& reserved)
{
  std::vector<std::string> mistakes;
  for (const auto& item : given) {
    const std::string& key = item.first;
    if (std::find(reserved.begin(), reserved.end(), key) != reserved.end())
      mistakes.push_back(fmt::format("\"{}\" of {} is set by ndframe; remove it.", key, library));
    else if (!valid.isParameter(key))
      mistakes.push_back(unknownKey(key, valid, library));
    else if (const std::string reason = wrongValue(key, item.second, valid.getEntry(key), library); !reason.empty())
      mistakes.push_back(reason);
  }
  return mistakes;
}

Teuchos::ParameterList conformed(const Teuchos::ParameterList& given, const Teuchos::ParameterList& valid)
{
  Teuchos::ParameterList list = given;
  for (const auto& item : given)
    if (const auto* entry = valid.getEntryPtr(item.first); entry != nullptr && isIntForDouble(item.second, *entry))
      list.set(item.first, double(given.get<int>(item.first)));
  return list;
}

} // namespace ndframe
