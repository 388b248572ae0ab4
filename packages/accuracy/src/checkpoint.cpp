#include "ndframe/accuracy/checkpoint.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ndframe
{

using Json = nlohmann::json;

namespace
{

/// The parameters of an effective deck by their paths, without those that change nothing in the levels so far.
std::map<std::string, std::string> parametersOf(const std::string& deckJson)
{
  Json deck = Json::parse(deckJson, nullptr, false);
  if (!deck.is_object())
    return {{"the deck", deckJson}};
  for (const char* key : {"Title", "Output", "Expect"})
    deck.erase(key);
  if (const auto accuracy = deck.find("Accuracy"); accuracy != deck.end())
    for (const char* key : {"Maximum Dofs", "Maximum Levels", "Maximum Memory", "Maximum Time"})
      accuracy->erase(key);
  std::map<std::string, std::string> parameters;
  const Json flat = deck.flatten();
  for (const auto& [path, value] : flat.items())
    parameters[path.substr(1)] = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  parameters.erase("Coupling/Stopping/Maximum Sweeps");
  return parameters;
}

} // namespace

std::string differenceOf(const std::string& deckJson, const std::string& earlierJson)
{
  const auto now = parametersOf(deckJson), before = parametersOf(earlierJson);
  std::vector<std::string> differences;
  for (const auto& [path, value] : now) {
    const auto known = before.find(path);
    if (known == before.end())
      differences.push_back(fmt::format("{} is {} and was not there", path, value));
    else if (known->second != value)
      differences.push_back(fmt::format("{} is {} and was {}", path, value, known->second));
  }
  for (const auto& [path, value] : before)
    if (now.count(path) == 0)
      differences.push_back(fmt::format("{} is not there and was {}", path, value));
  if (differences.empty())
    return {};
  return differences.front() + (differences.size() > 1 ? fmt::format(", and {} more", differences.size() - 1) : "");
}

} // namespace ndframe
