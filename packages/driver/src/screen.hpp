#pragma once

#include <cstdint>
#include <string>

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/driver/model.hpp"
#include "ndframe/io/summary.hpp"

namespace ndframe
{

/// 12345678 -> "12 345 678".
std::string grouped(std::int64_t number);

/// The header: bodies, dofs, solver, what holds them, interfaces.
std::string headerText(const RunSummary& summary, const Model& model, bool rolesAreKnown);

/// Title line of the sweeps, and one line a sweep.
std::string sweepTitle(const InterfaceMesh& interface, const Model& model);
std::string sweepLine(const SweepRecord& record);

/// The closing tables: energies, contact, residuals.
std::string closingText(const RunSummary& summary);

/// Seconds and memory of every stage.
std::string stageText(const RunSummary& summary);

} // namespace ndframe
