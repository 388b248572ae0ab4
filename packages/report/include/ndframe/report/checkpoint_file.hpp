#pragma once

#include "ndframe/accuracy/adaptive_run.hpp"

namespace ndframe
{

/// What a run with a target goes on from and what it leaves (Output/Checkpoint), in NAME.checkpoint. goesOn: --restart;
/// then the file is read by rank 0, and InputError says what is wrong with it, also that its run has reached its end.
/// Everything must live as long as the result. Collective.
Restart restartOf(const OutputOptions& output, const std::string& deckName, bool goesOn, const Comm& comm,
                  Ledger& ledger);

/// Marks NAME.checkpoint as that of a run whose results are written, if it has reached its target: there is nothing
/// left to go on with. Collective.
void endCheckpoint(const Run& run, const OutputOptions& output, const std::string& deckName,
                   const std::vector<std::string>& written, const Comm& comm);

} // namespace ndframe
