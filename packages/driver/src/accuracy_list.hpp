#pragma once

#include "ndframe/accuracy/accuracy_components.hpp"
#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// The list Accuracy of the deck.
ListSpec accuracySpec(const AccuracyComponents& components);

/// What a deck with the list Accuracy means where it says nothing: it estimates errors, with one sweep over the stars
/// (which costs less than the dofs that it saves), and a Neumann-Dirichlet iteration begins with a traction that
/// carries the loads.
void completeAccuracyDeck(DeckList& deck, Diagnostics& diagnostics);

/// Reads it; for decks that have it.
AccuracyOptions accuracyOptions(const Params& deck);

/// Refuses Output/Checkpoint of a run that has nothing to continue from.
void checkCheckpoint(const RunSettings& settings, const Coupling& coupling, Diagnostics& diagnostics);

/// Refuses a list Accuracy that names no target or two, or that this deck cannot serve.
void checkAccuracy(const RunSettings& settings, const AccuracyComponents& components, Diagnostics& diagnostics);

} // namespace ndframe
