#pragma once

#include "ndframe/base/ledger.hpp"
#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// The stages of a run: planned, timed by the ledger, listed in the summary.
enum class Stage
{
  Gmsh,
  Mpi,
  Krylov,
  Read,
  Check,
  Assemble,
  Factor,
  Interface,
  Couple,
  Recover,
  Certificate,
  CertifyTraction,
  CertifyFields,
  CertifyRecovery,
  CertifyEquilibrium,
  CertifyEstimators,
  CertifyReference,
  Refine,
  Stress,
  Write,
  LevelTable,
  WriteLevels,
  ContactTable,
  Expect
};

const Names<Stage>& stageNames(); ///< as the stage table calls them

/// Times a stage as long as the result lives.
[[nodiscard]] Ledger::Timer timeStage(Ledger& ledger, Stage stage);

} // namespace ndframe
