#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/run/accuracy_options.hpp"
#include "ndframe/run/accuracy_summary.hpp"

namespace ndframe
{

/// Whether this answer is to be preferred: by its guarantee first, by its bound then.
bool isBetter(const LevelSummary& level, const LevelSummary& other);

/// Whether the bound of the last level is not guaranteed and that of one before is. Round-off in the smallest cells may
/// do that, and then finer meshes do not help. levels: at least one.
bool lostGuarantee(const std::vector<LevelSummary>& levels);

/// Why a finer mesh would not help or is not wanted; empty when it is. levels: up to the present one.
std::string endOfProgress(const AccuracyOptions& options, const std::vector<LevelSummary>& levels,
                          const CouplingResult& coupling);

/// Which limit meshes with so many dofs would exceed; empty when none. memory: bytes that they would take.
std::string limitMet(const AccuracyOptions& options, const std::vector<LevelSummary>& levels, std::int64_t nextDofs,
                     double memory);

} // namespace ndframe
