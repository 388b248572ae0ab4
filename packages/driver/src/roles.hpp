#pragma once

#include "ndframe/base/log.hpp"
#include "ndframe/coupling/coupling.hpp"
#include "ndframe/driver/run.hpp"

namespace ndframe
{

/// `Dirichlet Body` = `Automatic`: who is Dirichlet body is not the deck's business but found out.

/// Turns interfaces of a model that was just built so that every body has one role, the first interface of each
/// connected part as the deck says. Bodies that touch in a ring of odd length have no such roles: a mistake.
void giveOneRole(Model& model, const Params& deck, Diagnostics& diagnostics);

/// Exchanges the roles of the bodies in each connected part of the condensed scene where the iteration then contracts
/// clearly better, and says so in the summary and on the screen. No factorisation: the stiffness on the interface
/// stays, what is counted along n_c changes its sign.
void chooseRoles(Run& run, Ledger& ledger, const Log& log);

/// Undoes what chooseRoles exchanged: the scene is again as it was condensed.
void giveBackRoles(Model& model, CondensedModel& condensed);

/// Turns the interfaces of a model that was just built as those of another model of the same deck.
void orientLike(Model& model, const Model& other);

} // namespace ndframe
