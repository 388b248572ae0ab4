#include "certificate/deck_run.hpp"

#include <filesystem>
#include <fstream>

#include "ndframe/base/log.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/tied_deck.hpp"

namespace ndframe::test
{
namespace
{

const Components& allComponents()
{
  static const auto all = makeComponents();
  return *all;
}

} // namespace

std::string writeScene(const DrawnScene& scene, const std::string& folder)
{
  const std::filesystem::path place = folder;
  std::filesystem::create_directories(place);
  for (const auto& [name, text] : scene.files)
    std::ofstream(place / name) << text;
  const auto path = place / "scene.xml";
  std::ofstream(path) << scene.deck.xml();
  return path.string();
}

Run runDeckFile(const std::string& path)
{
  Diagnostics diagnostics;
  const Params deck = validateScene(readDeck(path), makeDeckSpec(allComponents()), diagnostics);
  diagnostics.throwIfAny();
  Ledger ledger;
  return runDeck(deck, allComponents(), Comm::single(), ledger, silentLog());
}

} // namespace ndframe::test
