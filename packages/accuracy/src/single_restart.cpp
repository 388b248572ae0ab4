#include <fmt/format.h>

#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/run/summarize.hpp"

namespace ndframe
{

void refuseOtherDeck(const Restart& restart, const RunSettings& settings)
{
  const std::string difference = differenceOf(toJson(settings.deck), restart.from->deckJson);
  if (!difference.empty())
    throw InputError(fmt::format("\"{}\" belongs to another deck: {}; use the original deck, or run without --restart.",
                                 restart.file, difference));
}

SweepsKept sweepsOf(const Restart& restart, const RunSettings& settings, const SharedPasses& shared)
{
  SweepsKept sweeps;
  if (restart.from) {
    refuseOtherDeck(restart, settings);
    sweeps.after = restart.from->sweeps->done;
  }
  if (!restart.write)
    return sweeps;
  sweeps.every = restart.sweeps;
  sweeps.keep = [&restart, &shared, deck = toJson(settings.deck)](const SweepsDone& done) {
    Checkpoint checkpoint;
    checkpoint.version = versionText();
    checkpoint.deckJson = deck;
    checkpoint.sweeps.emplace();
    checkpoint.sweeps->done = done;
    if (haveFields(done))
      checkpoint.shared = shared;
    restart.write(checkpoint);
  };
  return sweeps;
}

} // namespace ndframe
