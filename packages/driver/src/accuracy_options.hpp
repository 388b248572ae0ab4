#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "ndframe/base/params.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// Whose error is bounded.
enum class AccuracyOf
{
  Displacement, ///< |u - u_h|, the global bound
  MeanStress    ///< |sigma - (sigma^ + K eps(u^)) / 2|, about half of it
};

/// The mesh to begin with.
enum class AccuracyStart
{
  Coarsest, ///< boxes with as few cells as their sides allow; meshes from files as they are
  Deck
};

const Names<AccuracyOf>& accuracyOfNames();
const Names<AccuracyStart>& accuracyStartNames();

/// The list Accuracy, read.
struct AccuracyOptions
{
  double target = 0.0;
  bool relative = true; ///< to sqrt(a(u_h, u_h))
  AccuracyOf of = AccuracyOf::Displacement;
  AccuracyStart start = AccuracyStart::Coarsest;
  std::int64_t maximumDofs = 0;
  int maximumLevels = 0;
  double maximumMemory = std::numeric_limits<double>::infinity();  ///< bytes
  double maximumSeconds = std::numeric_limits<double>::infinity(); ///< on the wall
  double iterationShare = 0.0;
};

/// True when the deck names an accuracy instead of relying on its mesh.
bool wantsAccuracy(const Params& deck);

/// For decks that do.
AccuracyOptions accuracyOptions(const Params& deck);

ListSpec accuracySpec(const Components& components);

/// What a deck with the list Accuracy means where it says nothing: it estimates errors, with one sweep over the stars
/// (which costs less than the dofs that it saves), and a Neumann-Dirichlet iteration begins with a traction that
/// carries the loads.
void completeAccuracyDeck(DeckList& deck, Diagnostics& diagnostics);

/// True when the sweeps on a mesh end by their part of the error; false when Coupling/Stopping ends them.
bool balancesSweeps(const Params& accuracy, const Components& components);

/// Refuses a list Accuracy that names no target or two, or that this deck cannot serve.
void checkAccuracy(const Params& deck, const Components& components, Diagnostics& diagnostics);

} // namespace ndframe
