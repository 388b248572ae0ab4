#include "certificate/trial.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "certificate/deck_run.hpp"

namespace ndframe::test
{
namespace
{

/// Round-off, relative to the bound; larger where the solution's own residual is.
constexpr double leastRoundOff = 1e-9;
/// Largest defect of the recovered stress, relative.
constexpr double largestDefect = 1e-11;

/// Reasons for a bound without a guarantee that are limits of the theory, not mistakes.
const std::vector<std::string> knownLimits{"not proven for tetrahedra", "accounts for in 2D only", "not certain near",
                                           "field of finite energy", "where supports hold both"};

bool isKnownLimit(const std::string& reason)
{
  for (const auto& limit : knownLimits)
    if (reason.find(limit) != std::string::npos)
      return true;
  return false;
}

/// What a bound that is guaranteed may have wrong: loads that were missed.
void judgeLoad(Trial& trial, const Run& run, const ExpectedLoad& load)
{
  constexpr double resultants = 1e-9;
  const double found = run.summary.bodies.front().loadForce.back();
  const double wrong = std::abs(found - load.resultant) / load.size;
  if (trial.errors.guaranteed && !(wrong <= resultants))
    trial.violations.push_back(
        fmt::format("guaranteed with the load {} instead of {}, wrong by {:.1e}", found, load.resultant, wrong));
}

void fill(Trial& trial, const std::string& deck, const DrawnScene& scene)
{
  try {
    const Run run = runDeckFile(deck);
    trial.order = run.summary.bodies.front().order;
    if (const auto& coupling = run.summary.coupling) {
      trial.sweeps = coupling->sweeps;
      trial.converged = coupling->converged;
    }
    trial.seconds = run.summary.totalSeconds;
    if (!run.summary.errors) {
      trial.refused = run.failure;
      return;
    }
    trial.errors = *run.summary.errors;
    trial.violations = judge(trial.errors, std::max(leastRoundOff, 10.0 * run.summary.residuals.equilibrium));
    trial.excused = !trial.errors.guaranteed && isKnownLimit(trial.errors.reason);
    if (scene.load)
      judgeLoad(trial, run, *scene.load);
    if (!trial.errors.guaranteed && !trial.excused)
      trial.violations.push_back("not guaranteed: " + trial.errors.reason);
  } catch (const InputError& error) {
    trial.refused = error.what();
  } catch (const std::exception& error) {
    trial.violations.push_back(error.what());
  }
}

} // namespace

std::vector<std::string> judge(const ErrorSummary& errors, double roundOff)
{
  std::vector<std::string> wrong;
  const auto require = [&](const char* what, double error, double bound) {
    if (!(error <= bound * (1.0 + roundOff)))
      wrong.push_back(fmt::format("{}: error {} above {} by {:.1e}", what, error, bound, error / bound - 1.0));
  };
  const auto& bound = *errors.global;
  const auto& reference = *errors.reference;
  if (reference.refinements < 3)
    wrong.push_back(fmt::format("the reference has cells of h/{} only", 1 << reference.refinements));
  require("displacement", reference.displacement, bound.absolute);
  require("stress", *reference.stress, bound.absolute);
  require("mean stress", *reference.meanStress, *errors.meanStress);
  require("equilibrium", *errors.equilibrium, largestDefect);
  return wrong;
}

Trial runTrial(const DrawnScene& scene, int index, const std::string& folder, bool keep)
{
  const std::string place = fmt::format("{}/scene-{}", folder, index);
  Trial trial;
  trial.index = index;
  trial.kind = scene.kind;
  fill(trial, writeScene(scene, place), scene);
  if (!trial.violations.empty()) {
    // The reference is a finite element solution, which penetrates between its nodes: it misses what the proof asks of
    // the true one by what vanishes with h. A violation is one if a reference four times finer still shows it.
    trial.violations.clear();
    DrawnScene finer = scene;
    finer.deck.set("Error Estimation/Reference/Refinements", 5);
    fill(trial, writeScene(finer, place), finer);
  }
  if (trial.violations.empty() && !keep)
    std::filesystem::remove_all(place);
  return trial;
}

} // namespace ndframe::test
