#pragma once

#include <optional>

#include "ndframe/certification/error_options.hpp"
#include "ndframe/run/output_options.hpp"

namespace ndframe
{

/// The list Error Estimation; `recoveries`: the ways to find equilibrated stresses.
ListSpec errorEstimationSpec(const Choices& recoveries);

/// Reads it; for decks that have it.
ErrorOptions errorOptions(const Params& deck);

/// Refuses what Error Estimation and Output ask for and this deck cannot give: estimators without their inputs, a
/// guarantee from the paper's formula.
void checkErrorEstimation(const std::optional<ErrorOptions>& errors, const OutputOptions& output,
                          Diagnostics& diagnostics);

} // namespace ndframe
