#pragma once

#include <filesystem>
#include <functional>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

struct Model;

/// Which states NAME.e holds.
enum class StepsWritten
{
  Final,
  AllSweeps
};

const Names<StepsWritten>& stepsNames();

/// Folder (made if missing) and beginning of the names of a deck's files. `output`: the list Output.
std::filesystem::path outputStem(const Params& output, const std::string& deckName);

/// Refuses an output folder that cannot be made or written in, and names too long for a file, before anything is
/// computed. `deckName`: the deck's file.
void checkOutput(const Params& deck, const std::string& deckName);

/// Refuses a beginning of file names that is too long. `output`: the list Output.
void checkNameLength(const Params& output, const std::string& name);

/// Refuses names of bodies, sides and interfaces that are too long for NAME.e, if the deck wants it.
void checkFieldNames(const Model& model, const Params& deck, Diagnostics& diagnostics);

/// Rank 0 writes; its InputError is everybody's. Collective.
void writeOnFirstRank(const Comm& comm, const std::function<void()>& write);

} // namespace ndframe
