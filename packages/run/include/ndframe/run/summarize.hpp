#pragma once

#include "ndframe/base/ledger.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Version of this build.
std::string versionText();

/// The summary of a scene before anything is solved: names, sizes, all numbers zero.
RunSummary outlineSummary(const Model& model, const RunSettings& settings, const LinearSolver& solver, int ranks);

/// Names the Dirichlet and Neumann bodies of the interfaces as the model has them.
void nameSides(RunSummary& summary, const Model& model);

/// The roles that were chosen; empty where they were not.
std::vector<RoleSummary> rolesOf(const Run& run);

/// The outline in run.summary with what the run computed; without a solution only why there is none. Collective.
RunSummary completeSummary(const Run& run, const RunSettings& settings, const Comm& comm);

/// Copies counts, those of reductions among them (countReductions), stages and memory; called again after the files are
/// written.
void copyLedger(RunSummary& summary, Ledger& ledger, double startSeconds);

/// Why a result is not what the equations ask for: the iteration did not converge, or a residual is too large. Empty
/// when it is right. Of a run with a target the iteration is not asked: the bound holds for the state of any sweep, and
/// whether it meets the target is another question.
std::string distrust(const RunSummary& summary);

/// Compares what is expected with the summary.
void checkExpectations(RunSummary& summary, const RunSettings& settings);

/// True when `path` names a number of the summary that this deck will give. `outline`: outlineSummary.
bool isQuantity(const std::string& path, const RunSummary& outline, const RunSettings& settings);

/// Refuses probes of places that the model does not have, and expectations of quantities that the summary will not
/// have.
void checkWantedNumbers(const Model& model, const RunSettings& settings, const LinearSolver& solver,
                        Diagnostics& diagnostics);

} // namespace ndframe
