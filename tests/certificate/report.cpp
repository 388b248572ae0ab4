#include "certificate/report.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace ndframe::test
{
namespace
{

double valueOf(const std::optional<double>& value)
{
  return value.value_or(0.0);
}

/// In a table of commas.
std::string plain(std::string text)
{
  for (char& c : text)
    if (c == ',' || c == '\n' || c == '"')
      c = ';';
  return text;
}

struct Group
{
  std::vector<double> effectivity, mean;
};

/// Every word of a kind and every method is a group of its own.
std::map<std::string, Group> groups(const std::vector<Trial>& trials)
{
  std::map<std::string, Group> all;
  for (const auto& trial : trials) {
    if (!trial.refused.empty() || !trial.errors.reference || !trial.errors.reference->effectivity)
      continue;
    const ErrorSummary& errors = trial.errors;
    std::vector<std::string> names{"all", fmt::format("P{} {} q{}", trial.order, errors.recovery, errors.degree),
                                   errors.interfaceTraction};
    for (std::size_t start = 0; start < trial.kind.size();) {
      const auto space = std::min(trial.kind.find(' ', start), trial.kind.size());
      names.push_back(trial.kind.substr(start, space - start));
      start = space + 1;
    }
    for (const auto& name : names)
      if (!name.empty()) {
        all[name].effectivity.push_back(*errors.reference->effectivity);
        all[name].mean.push_back(valueOf(errors.reference->meanStressEffectivity));
      }
  }
  return all;
}

} // namespace

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : 0.5 * (values[values.size() / 2] + values[(values.size() - 1) / 2]);
}

std::string titleRow()
{
  return "scene,kind,order,recovery,degree,traction,sweeps,converged,bound,elements,contact,projection,oscillation,"
         "mean bound,guaranteed,reason,error,stress error,mean error,effectivity,mean effectivity,equilibrium,"
         "refinements,seconds,refused,violations\n";
}

std::string row(const Trial& trial)
{
  const ErrorSummary& errors = trial.errors;
  const auto bound = errors.global.value_or(ErrorMeasureSummary{});
  const auto reference = errors.reference.value_or(ReferenceSummary{});
  std::string wrong;
  for (const auto& violation : trial.violations)
    wrong += violation + ". ";
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.2f},{},{}\n", trial.index, trial.kind,
      trial.order, errors.recovery, errors.degree, errors.interfaceTraction, trial.sweeps, trial.converged,
      bound.absolute, bound.elements, bound.contact, bound.projection, bound.oscillation, valueOf(errors.meanStress),
      errors.guaranteed, plain(errors.reason), reference.displacement, valueOf(reference.stress),
      valueOf(reference.meanStress), valueOf(reference.effectivity), valueOf(reference.meanStressEffectivity),
      valueOf(errors.equilibrium), reference.refinements, trial.seconds, plain(trial.refused), plain(wrong));
}

std::string report(const std::vector<Trial>& trials)
{
  int refused = 0, excused = 0, wrong = 0;
  double defect = 0.0;
  for (const auto& trial : trials) {
    refused += !trial.refused.empty();
    excused += trial.excused;
    wrong += !trial.violations.empty();
    defect = std::max(defect, valueOf(trial.errors.equilibrium));
  }
  std::string text = fmt::format("{} scenes: {} without a certificate (refused), {} not guaranteed, {} wrong; largest "
                                 "defect of equilibrium {:.1e}\n\n{:<24}{:>6}{:>10}{:>8}{:>10}{:>14}{:>8}\n",
                                 trials.size(), refused, excused, wrong, defect, "group", "", "median", "least",
                                 "largest", "mean stress", "least");
  for (const auto& [name, group] : groups(trials)) {
    const auto [least, largest] = std::minmax_element(group.effectivity.begin(), group.effectivity.end());
    text += fmt::format("{:<24}{:>6}{:>10.3f}{:>8.3f}{:>10.3f}{:>14.3f}{:>8.4f}\n", name, group.effectivity.size(),
                        median(group.effectivity), *least, *largest, median(group.mean),
                        *std::min_element(group.mean.begin(), group.mean.end()));
  }
  for (const auto& trial : trials)
    for (const auto& violation : trial.violations)
      text += fmt::format("WRONG: scene {} ({}): {}\n", trial.index, trial.kind, violation);
  return text;
}

bool violated(const std::vector<Trial>& trials)
{
  return std::any_of(trials.begin(), trials.end(), [](const Trial& trial) { return !trial.violations.empty(); });
}

} // namespace ndframe::test
