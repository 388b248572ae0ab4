#pragma once

#include <string>
#include <vector>

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/run/run_settings.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{

/// A stage of a run, whether this deck needs it, and why (not).
struct PlannedStage
{
  Stage stage;     ///< timed under its name
  bool runs;       ///< with this deck
  std::string why; ///< what it does, or why it is left out
};

/// What a deck will run, the stages by the names that the ledger times them under: printed by --plan, followed by the
/// run, compared with the ledger by tests.
class Plan
{
public:
  Plan() = default;
  Plan(const RunSettings& settings, const LinearSolver& solver, int ranks); ///< ranks: processes

  /// Throws InternalError for a stage that is not planned at all: a part of the certificate without its list.
  bool runs(Stage stage) const;
  const std::vector<PlannedStage>& stages() const { return stages_; } ///< as --plan lists them
  std::string text() const;                                           ///< the table of --plan, without the last newline

private:
  void add(Stage stage, bool runs, std::string whyRuns, std::string whySkipped);
  void addCertificate(const RunSettings& settings);
  std::vector<PlannedStage> stages_;
};

} // namespace ndframe
