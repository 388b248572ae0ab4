#pragma once

#include <cstdint>
#include <string>

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/driver/model.hpp"
#include "ndframe/io/summary.hpp"

namespace ndframe
{

/// What is said of a deck that the process has too little memory for.
constexpr const char* needsMoreMemory =
    "this deck needs more memory than the process may take; use a coarser mesh, fewer threads (OMP_NUM_THREADS), more "
    "ranks or a Krylov solver.";

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
