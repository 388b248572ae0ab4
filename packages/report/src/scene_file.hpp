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

/// Whether a scene's file is written by all processes: in pieces, or because they have shares of it.
bool isWrittenByAll(const OutputOptions& output, const ExodusScene& scene, const Comm& comm);

/// Writes `path` as one file and removes pieces of it that an earlier run left; called by one rank.
std::vector<std::string> writeWhole(const std::string& path, const SceneContent& content, Ledger& ledger);

/// Writes the pieces of `path`, one on each rank, or, where ranks have shares of the scene, one file to which they add
/// their parts one after the other, so that none has the whole; then they must see the same folder, and nodes and
/// elements of a rank follow those of the ranks before it. All pieces appear or none. What an earlier run left, the
/// whole or pieces of another number of processes, is removed then. Returns the names. Throws InputError on every rank
/// when one cannot write. Collective.
std::vector<std::string> writeByAll(const std::string& path, const OutputOptions& output, const SceneContent& content,
                                    const Comm& comm, Ledger& ledger);

/// Removes the file and all pieces of it, as far as they are there.
void removeScene(const std::string& path);

} // namespace ndframe
