// Runs a deck, shows it on a screen of the program's own and writes the files of results.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "ndframe/base/deck.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/driver/tied_deck.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/report/screen.hpp"
#include "ndframe/report/screen_observer.hpp"
#include "ndframe/run/run_once.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  DeckList deck = parseDeck(defaultDeck(), "default"); // two blocks; their sides that touch have 8 edges each
  Diagnostics mistakes;
  applySetting(deck, "Output/Directory=report-example", mistakes);
  const RunSettings settings = readSettings(validateScene(deck, makeDeckSpec(*components), mistakes));
  mistakes.throwIfAny();
  checkOutput(settings, "blocks.xml"); // before anything is computed

  const Comm comm = Comm::single();
  Ledger ledger;
  std::ostringstream screen;
  const Log log(screen, Verbosity::Normal, true, false); // this rank speaks; no terminal
  ScreenObserver observer(log);
  Run run = runOnce(RunTools(settings, *components, comm, ledger), observer, {});
  log.line(closingText(run.summary));
  const std::vector<std::string> files = writeResults(run, settings.output, "blocks.xml", comm, ledger);

  bool ok = files.size() == 3; // for ParaView, the table of contact and the summary
  for (const std::string& file : files)
    ok = ok && std::filesystem::exists(file);
  std::ifstream table("report-example/blocks.contact.csv");
  const auto lines = std::count(std::istreambuf_iterator<char>(table), {}, '\n');
  ok = ok && lines == 1 + 17; // names of the columns, and the nodes of second order
  for (const char* shown : {"17 interface nodes, matching, no gap", "17/0", "interface contact"})
    ok = ok && screen.str().find(shown) != std::string::npos;
  std::filesystem::remove_all("report-example");
  return ok ? 0 : 1;
}
