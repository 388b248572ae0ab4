#pragma once

#include "ndframe/accuracy/accuracy_components.hpp"
#include "ndframe/run/accuracy_options.hpp"

namespace ndframe
{

/// The list Accuracy of the deck.
ListSpec accuracySpec(const AccuracyComponents& components);

/// What a deck with the list Accuracy means where it says nothing: it estimates errors, with one sweep over the stars
/// (which costs less than the dofs that it saves), and a Neumann-Dirichlet iteration begins with a traction that
/// carries the loads.
void completeAccuracyDeck(DeckList& deck, Diagnostics& diagnostics);

/// True when the sweeps on a mesh end by their part of the error; false when Coupling/Stopping ends them.
bool balancesSweeps(const Params& accuracy, const AccuracyComponents& components);

/// Refuses a list Accuracy that names no target or two, or that this deck cannot serve.
void checkAccuracy(const Params& deck, const AccuracyComponents& components, Diagnostics& diagnostics);

} // namespace ndframe
