#pragma once

#include <string>
#include <vector>

#include "ndframe/io/exodus_writer.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// What an Exodus file of a run has in all its steps; it refers to the meshes of the run's model.
struct ExodusScene
{
  std::string title;
  std::vector<ExodusBody> bodies;
  std::vector<ExodusContactSide> sides;
  /// Of bodies that are shared out; empty: the bodies are whole.
  std::vector<std::shared_ptr<const BodyShare>> shares{};
  std::vector<std::vector<int>> ranks{}; ///< per body and vertex, that have its rows; empty where that is not known
};

ExodusScene exodusScene(const Run& run);

/// The fields of one of the states that a solved run keeps (Solved::states).
ExodusStep exodusStep(const Run& run, const OutputOptions& output, std::size_t step);

/// The information records: program and deck.
std::vector<std::string> exodusRecords(const std::string& deckName);

} // namespace ndframe
