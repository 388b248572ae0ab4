#pragma once

#include "ndframe/accuracy/checkpoint.hpp"
#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// The bytes of a checkpoint's file. Throws InputError.
std::string contentsOf(const std::string& path);

/// Whether each rank has a part of the fields (SharedPasses); the same on all ranks.
bool isInPieces(const Checkpoint& checkpoint);

/// Writes each rank's part as "NAME.checkpoint.STAMP.N.r" and then NAME.checkpoint with the rest, which says what the
/// parts are called: until it is there, the one before and its parts are, which are removed then. Collective.
void writeCheckpointPieces(const std::string& path, const Checkpoint& checkpoint, const Comm& comm);

/// Reads the parts that the checkpoint of this path says it has, in turn on all ranks, which may be others than those
/// that wrote them; a rank adds up the parts that it reads. Throws InputError on all ranks. Collective.
void readCheckpointPieces(const std::string& path, Checkpoint& checkpoint, const Comm& comm);

/// Removes all parts but those of this stamp. On one rank.
void removeCheckpointPieces(const std::string& path, const std::string& stamp);

} // namespace ndframe
