#pragma once

#include <cstdint>
#include <string>

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/run/run_summary.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The header: bodies, dofs, solver, what holds them, interfaces.
std::string headerText(const RunSummary& summary, const Model& model, bool rolesAreKnown);

/// Who has become Dirichlet body and why; one line a connected part.
std::string rolesText(const std::vector<RoleSummary>& roles);

/// Title line of the sweeps, and one line a sweep.
std::string sweepTitle(const InterfaceMesh& interface, const Model& model);
std::string sweepLine(const SweepRecord& record); ///< below sweepTitle

/// The closing tables: energies, contact, residuals.
std::string closingText(const RunSummary& summary);

/// Seconds and memory of every stage.
std::string stageText(const RunSummary& summary);

} // namespace ndframe
