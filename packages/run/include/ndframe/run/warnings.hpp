#pragma once

#include "ndframe/run/run.hpp"
#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// What the scene shows before anything is solved.
std::vector<Warning> sceneWarnings(const Model& model, const RunSettings& settings);

/// What only the answer shows; of a run with a solution. summary: with what the run computed for the bodies.
/// Collective.
std::vector<Warning> answerWarnings(const Run& run, const RunSummary& summary, const RunSettings& settings,
                                    const Comm& comm);

/// The warnings of the scene are mistakes.
void refuseWarnings(const Model& model, const RunSettings& settings, Diagnostics& diagnostics);

/// "large strain: Bodies/punch: strains reach ..." for the summary and the screen.
WarningSummary warningSummary(const Warning& warning);

/// "warning: ..." lines of the screen, one a warning.
std::string warningText(const WarningSummary& warning);

/// Top-level parameters of the deck that warnings need.
std::vector<ParamSpec> warningParams();

} // namespace ndframe
