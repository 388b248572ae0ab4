#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "ndframe/base/list_place.hpp"

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

/// How a deck calls the values of each enumeration.
const Names<AccuracyOf>& accuracyOfNames();
const Names<AccuracyStart>& accuracyStartNames(); ///< of Start

/// Lists of components, for their builders.
struct AccuracyLists
{
  Params marking = Params(nullptr), refinement = Params(nullptr), transfer = Params(nullptr),
         stopping = Params(nullptr);
};

/// The list Accuracy, read.
struct AccuracyOptions
{
  ListPlace place;                               ///< for mistakes that show later
  double target = 0.0;                           ///< of the bound: a share, or absolute in the energy norm
  bool relative = true;                          ///< to sqrt(a(u_h, u_h))
  AccuracyOf of = AccuracyOf::Displacement;      ///< whose error the bound is of
  AccuracyStart start = AccuracyStart::Coarsest; ///< the first meshes
  std::int64_t maximumDofs = 0;                  ///< no mesh is refined to more
  int maximumLevels = 0;                         ///< the first one included
  double maximumMemory = std::numeric_limits<double>::infinity();  ///< bytes
  double maximumSeconds = std::numeric_limits<double>::infinity(); ///< on the wall
  double iterationShare = 0.0; ///< sweeps end when their part of the error is below this share of the mesh's
  /// Accuracy/Marking/Type and Accuracy/Refinement/Type.
  std::string marking, refinement; ///< names of the components
  AccuracyLists lists;
};

} // namespace ndframe
