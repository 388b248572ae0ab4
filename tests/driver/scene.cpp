#include "driver/scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "ndframe/base/log.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/tied_deck.hpp"

namespace ndframe::test
{
namespace
{

using Change = std::function<std::string(const std::string&)>;

void changeIn(DeckList& list, const std::string& key, const Change& change)
{
  for (auto& entry : list.entries)
    if (entry.name == key)
      entry.value = change(entry.value);
  for (auto& sub : list.lists)
    changeIn(sub, key, change);
}

/// Multiplies a number or every number of an array.
Change times(double factor)
{
  return [factor](const std::string& value) {
    if (value.front() != '{')
      return fmt::format("{}", factor * std::stod(value));
    std::vector<double> numbers;
    std::istringstream text(value.substr(1, value.size() - 2));
    for (std::string number; std::getline(text, number, ',');)
      numbers.push_back(factor * std::stod(number));
    return fmt::format("{{{}}}", fmt::join(numbers, ", "));
  };
}

} // namespace

const Components& components()
{
  static const auto all = makeComponents();
  return *all;
}

std::string shippedDeck(const std::string& name)
{
  return std::string(NDFRAME_DECKS) + "/" + name + ".xml";
}

std::vector<std::string> shippedDecks()
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(NDFRAME_DECKS)) {
    if (entry.path().extension() != ".xml")
      continue;
    const DeckList deck = readDeck(entry.path().string());
    if (deck.findList("Study") == nullptr && deck.findList("Load Cases") == nullptr)
      names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Scene::Scene(const std::string& shippedName) : Scene(readDeck(shippedDeck(shippedName)))
{
  deck_.lists.erase(std::remove_if(deck_.lists.begin(), deck_.lists.end(),
                                   [](const DeckList& list) { return list.name == "Expect"; }),
                    deck_.lists.end());
}

Scene Scene::fromText(const std::string& xml)
{
  return Scene(parseDeck(xml, "test.xml"));
}

Scene Scene::fromFile(const std::string& path)
{
  return Scene(readDeck(path));
}

Scene& Scene::set(const std::string& setting)
{
  Diagnostics diagnostics;
  applySetting(deck_, setting, diagnostics);
  diagnostics.throwIfAny();
  return *this;
}

Scene& Scene::changeAll(const std::string& key, const Change& change)
{
  changeIn(deck_, key, change);
  return *this;
}

Scene& Scene::rotate(double degrees)
{
  for (auto& list : deck_.lists)
    for (std::size_t b = 0; list.name == "Bodies" && b < list.lists.size(); ++b)
      set(fmt::format("Bodies/{}/Mesh/Rotation={}", list.lists[b].name, degrees));
  return *this;
}

Scene& Scene::changeUnits(double length, double stress)
{
  for (const char* key : {"Lower", "Upper", "At"})
    changeAll(key, times(length));
  for (const char* key : {"Young Modulus", "Value"})
    changeAll(key, times(stress));
  return changeAll("Gap", [length](std::string gap) {
    for (auto at = gap.find('x'); at != std::string::npos; at = gap.find('x', at + 1)) {
      const std::string scaled = fmt::format("(x / {})", length);
      gap.replace(at, 1, scaled);
      at += 1;
    }
    return fmt::format("{} * ({})", length, gap);
  });
}

Scene& Scene::reverseBodies()
{
  for (auto& list : deck_.lists)
    if (list.name == "Bodies")
      std::reverse(list.lists.begin(), list.lists.end());
  return *this;
}

Params Scene::params() const
{
  Diagnostics diagnostics;
  Params params = validateScene(deck_, makeDeckSpec(components()), diagnostics);
  diagnostics.throwIfAny();
  return params;
}

Outcome Scene::run() const
{
  auto ledger = std::make_unique<Ledger>();
  Run run = runDeck(params(), components(), Comm::single(), *ledger, silentLog());
  return {std::move(ledger), std::move(run)};
}

std::string complaintOf(const Scene& scene)
{
  try {
    scene.run();
  } catch (const InputError& error) {
    return error.what();
  } catch (const NotConverged& error) {
    return error.what();
  }
  ADD_FAILURE() << "the scene runs";
  return {};
}

const Vector& displacement(const Run& run, int body)
{
  return run.solved.fields.at(std::size_t(body)).displacement.back();
}

double relativeDifference(const Vector& a, const Vector& b)
{
  EXPECT_EQ(a.size(), b.size());
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return largest > 0.0 ? difference / largest : difference;
}

std::vector<char> statuses(const Run& run)
{
  std::vector<char> all;
  for (const auto& node : run.solved.contact)
    all.push_back(node.closed);
  return all;
}

Vector traction(const Run& run)
{
  Vector all;
  for (const auto& node : run.solved.contact)
    all.push_back(node.tractionDirichlet);
  return all;
}

} // namespace ndframe::test
