#pragma once

#include <filesystem>
#include <functional>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

/// Which states NAME.e holds.
enum class StepsWritten
{
  Final,
  AllSweeps
};

const Names<StepsWritten>& stepsNames();

/// Folder (made if missing) and beginning of the names of a deck's files. `output`: the list Output.
std::filesystem::path outputStem(const Params& output, const std::string& deckName);

/// Refuses an output folder that cannot be made or written in, before anything is computed.
void checkOutputFolder(const Params& deck);

/// Rank 0 writes; its InputError is everybody's. Collective.
void writeOnFirstRank(const Comm& comm, const std::function<void()>& write);

} // namespace ndframe
