#pragma once

#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/base/log.hpp"
#include "ndframe/driver/components.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Runs a validated deck up to the summary; writes no files. A deck with the list Accuracy is run on as many meshes as
/// its target needs and reuses nothing. Of `previous` it keeps what the deck has not changed, with
/// the same answer as without (with the contact that it may have: within the tolerance of the coupling); the ledger
/// must be the one of the run that it comes from. Without a solution (a solver gives up, the load pulls a body off) the
/// summary says so. Throws InputError for mistakes that show only with the meshes; `previous` then holds what can still
/// be reused.
Run runDeck(const RunSettings& settings, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous = {}, const LevelObserver& onLevel = {}, const Restart& restart = {});

/// The same with the settings of a deck.
Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous = {}, const LevelObserver& onLevel = {});

/// Makes an earlier (or empty) model the deck's and checks everything that --check checks: meshes, pairing, supports,
/// expectations. With a target the model is that of the first meshes. Returns the settings with the interfaces that
/// Interfaces/Automatic found, if the deck has it; `log` says which.
RunSettings checkDeck(Model& model, const RunSettings& settings, const Components& components, const Comm& comm,
                      Ledger& ledger, const Log& log = silentLog());

} // namespace ndframe
