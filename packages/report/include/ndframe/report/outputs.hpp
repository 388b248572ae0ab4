#pragma once

#include <filesystem>
#include <functional>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Folder (made if missing) and beginning of the names of a deck's files.
std::filesystem::path outputStem(const OutputOptions& output, const std::string& deckName);

/// The same on every rank; a failure of any is everybody's InputError. Collective.
std::string commonStem(const OutputOptions& output, const std::string& deckName, const Comm& comm);

/// Names of files as the screen says them: of the pieces of one file only the first and the last.
std::string namesText(const std::vector<std::string>& files);

/// Refuses an output folder that cannot be made or written in, and names too long for a file, before anything is
/// computed. `deckName`: the deck's file.
void checkOutput(const RunSettings& settings, const std::string& deckName);

/// Refuses mesh files that NAME.e or its pieces would replace: InputError.
void checkMeshesStay(const RunSettings& settings, const std::string& deckName);

/// Refuses a beginning of file names that is too long.
void checkNameLength(const OutputOptions& output, const std::string& name);

/// Rank 0 writes; its InputError is everybody's. Collective.
void writeOnFirstRank(const Comm& comm, const std::function<void()>& write);

/// Writes NAME.level-01.e, ... if Output asks for all levels; else empty. Everything must live as long as the observer.
LevelObserver levelWriter(const OutputOptions& output, const std::string& name, const Comm& comm, Ledger& ledger);

/// Writes what Output asks for; returns the files' names. Rank 0 writes, or all do where the fields are written in
/// pieces; a failure is everybody's InputError. Collective.
std::vector<std::string> writeResults(Run& run, const OutputOptions& output, const std::string& name, const Comm& comm,
                                      Ledger& ledger);

} // namespace ndframe
