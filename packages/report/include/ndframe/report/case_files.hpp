#pragma once

#include <string>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/io/exodus_writer.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// The files that load cases on the same meshes share: each case is a step of NAME.e and has rows of NAME.contact.csv
/// and NAME.probes.csv. All of it stays in memory until it is written.
class CaseFiles
{
public:
  /// deckName: the deck's file. Every rank has one; what follows is collective.
  CaseFiles(OutputOptions output, std::string deckName, const Comm& comm);

  /// Takes what the files need of a run with a solution; number: of the case, from 1, the time of its step. Throws
  /// InputError when its meshes or interfaces are not those of the first one.
  void add(const Run& run, int number, const std::string& name);

  /// Writes NAME.e, NAME.contact.csv and NAME.probes.csv, as far as Output asks for them; returns their names. What no
  /// case has is removed where an earlier run left it. Throws InputError like all that writes.
  std::vector<std::string> write(Ledger& ledger);

private:
  bool keepsFields(const Run& run) const;
  std::vector<std::string> writeFields(const std::string& stem, Ledger& ledger);
  void addFields(const Run& run, int number, const std::string& name);
  void keepMeshes(const Run& run);
  bool sameMeshes(const Run& run) const;

  OutputOptions output_;
  std::string deckName_;
  Comm comm_;
  std::vector<Mesh> meshes_; ///< of the bodies, which the runs hand on to each other
  std::vector<NodeMap> nodes_;
  std::string title_;
  std::vector<ExodusBody> bodies_;
  std::vector<ExodusContactSide> sides_;
  std::vector<std::shared_ptr<const BodyShare>> shares_; ///< of bodies that are shared out
  std::vector<ExodusStep> steps_;                        ///< on the ranks that write them
  std::vector<std::string> names_;                       ///< "case 1: assembly"
  std::string contact_, probes_;                         ///< on rank 0
};

} // namespace ndframe
