#include "ndframe/run/warnings.hpp"

#include <cmath>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/scene/rigid_check.hpp"

namespace ndframe
{
namespace
{

struct SceneCheck
{
  const char* kind;
  void (*find)(const Model& model, const SceneSettings& scene, Diagnostics& found);
};

struct AnswerCheck
{
  const char* kind;
  void (*find)(const Answer& answer, const RunSettings& settings, Diagnostics& found);
};

constexpr SceneCheck sceneChecks[] = {{"different hypotheses", findDifferentHypotheses},
                                      {"different moduli", findDifferentModuli},
                                      {"locking", findLocking},
                                      {"unconnected parts", findUnconnectedParts},
                                      {"load on a support", findLoadsOnSupports},
                                      {"touching bodies", findTouchingBodies},
                                      {"not unique", findLooseBodies}};

constexpr AnswerCheck answerChecks[] = {{"strain", findStrangeStrain},
                                        {"few contact nodes", findFewContactNodes},
                                        {"contact at the end of a side", findContactAtEnds},
                                        {"overlapping bodies", findOverlaps}};

template <class Checks, class Subject, class Settings>
std::vector<Warning> collect(const Checks& checks, const Subject& subject, const Settings& settings)
{
  std::vector<Warning> warnings;
  for (const auto& check : checks) {
    Diagnostics found;
    check.find(subject, settings, found);
    for (const auto& diagnostic : found.list())
      warnings.push_back({check.kind, diagnostic});
  }
  return warnings;
}

} // namespace

std::vector<Warning> sceneWarnings(const Model& model, const RunSettings& settings)
{
  if (model.told)
    return model.told->warnings;
  std::vector<Warning> warnings = collect(sceneChecks, model, settings.scene);
  for (const Diagnostic& place : settings.unnamedFacing)
    warnings.push_back({"unnamed facets", place});
  return warnings;
}

std::vector<Warning> answerWarnings(const Run& run, const RunSummary& summary, const RunSettings& settings,
                                    const Comm& comm)
{
  if (!std::isfinite(summary.energy)) // the run says so itself
    return {};
  return collect(answerChecks, Answer{run, summary.bodies, comm}, settings);
}

void refuseWarnings(const Model& model, const RunSettings& settings, Diagnostics& diagnostics)
{
  for (const auto& warning : sceneWarnings(model, settings))
    diagnostics.add(warning.what);
}

WarningSummary warningSummary(const Warning& warning)
{
  return {warning.kind, warning.what.path.empty() ? warning.what.message
                                                  : fmt::format("{}: {}", warning.what.path, warning.what.message)};
}

std::string warningText(const WarningSummary& warning)
{
  return "warning: " + warning.message;
}

std::vector<ParamSpec> warningParams()
{
  return {{"Strict Input", false,
           "Warnings are errors: exit code 2 when the scene shows them before the solve, 6 when only the answer does."},
          {"Strain Limit", 0.05, above(0.0),
           "Larger strains give a warning: the theory assumes small strains. Raise it where only ratios matter, as "
           "with loads and moduli of 1."}};
}

} // namespace ndframe
