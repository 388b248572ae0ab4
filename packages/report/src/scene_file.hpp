#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/ledger.hpp"
#include "ndframe/io/exodus_writer.hpp"
#include "ndframe/run/output_options.hpp"
#include "run_fields.hpp"

namespace ndframe
{

/// What a file of fields is made of.
struct SceneContent
{
  const ExodusScene& scene;
  const std::vector<ExodusStep>& steps;
  std::vector<std::string> records; ///< information records
};

/// Whether a scene's file is written in pieces, by all processes; one with fewer cells than processes never is.
bool isInPieces(const OutputOptions& output, const ExodusScene& scene, const Comm& comm);

/// Writes `path` as one file and removes pieces of it that an earlier run left; called by one rank.
std::vector<std::string> writeWhole(const std::string& path, const SceneContent& content, Ledger& ledger);

/// Writes the pieces of `path`, one on each rank; all appear or none. What an earlier run left, the whole or pieces of
/// another number of processes, is removed then. Returns the names of all pieces. Throws InputError on every rank when
/// one cannot write. Collective.
std::vector<std::string> writePieces(const std::string& path, const SceneContent& content, const Comm& comm,
                                     Ledger& ledger);

/// Removes the file and all pieces of it, as far as they are there.
void removeScene(const std::string& path);

} // namespace ndframe
