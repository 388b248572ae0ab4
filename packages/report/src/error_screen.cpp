#include "ndframe/report/error_screen.hpp"

#include <fmt/format.h>

#include "ndframe/base/grouped.hpp"
#include "ndframe/certification/advice.hpp"
#include "ndframe/report/screen.hpp"

namespace ndframe
{
namespace
{

constexpr int nameColumn = 17;

/// Two decimals, and of less than one percent three digits.
std::string percent(double number)
{
  return fmt::format(fmt::runtime(number < 1.0 ? "{:.3g} %" : "{:.2f} %"), number);
}

/// One line: what, the number, and its share of the solution.
std::string line(const std::string& name, const std::string& sign, double absolute, std::optional<double> relative,
                 const std::string& remark)
{
  const auto share = relative ? percent(100.0 * *relative) : "";
  std::string text =
      fmt::format("\n  {:<{}} {:>2} {:>11.4g} {:>9}   {}", name, nameColumn, sign, absolute, share, remark);
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string arrow(bool points, const std::string& words)
{
  return points && !words.empty() ? "<- " + words : "";
}

/// What the data take of the bound: nothing to see unless it is much, which no sweeps and few finer meshes mend.
std::string dataText(const ErrorMeasureSummary& bound, const std::string& sign)
{
  constexpr double much = 0.25;
  if (!(bound.oscillation > much * bound.absolute))
    return "";
  const double share = bound.relative * (bound.oscillation / bound.absolute);
  return line("  data", sign, bound.oscillation, share,
              "<- loads or prescribed displacements jump or bend within cells; mesh lines along jumps (Splits of a "
              "Box) would help");
}

/// The bound with what it is worth.
std::string boundText(const ErrorSummary& errors)
{
  const bool holds = errors.guaranteed;
  std::string text;
  if (errors.global)
    text += line("error in energy", holds ? "<=" : "~", errors.global->absolute, errors.global->relative,
                 holds ? "of the solution, guaranteed" : "of the solution, not guaranteed: " + errors.reason) +
            dataText(*errors.global, holds ? "<=" : "~");
  return text;
}

/// Indicators: they share the bound out, and either may exceed its share.
std::string partsText(const ErrorSummary& errors)
{
  const bool isMesh = meshDominates(errors);
  std::string text;
  const auto add = [&](const char* name, const std::optional<ErrorMeasureSummary>& part, bool isLarger) {
    if (part)
      text += line(name, "~", part->absolute, part->relative, arrow(isLarger, errors.advice));
  };
  add("  mesh", errors.discretization, isMesh);
  add("  iteration", errors.algorithm, !isMesh);
  if (errors.splitStress)
    text += line("  mesh, by Split", "~", *errors.splitStress, {}, "the bound without the iteration's part");
  return text;
}

std::string meanStressText(const ErrorSummary& errors)
{
  return errors.meanStress ? line("mean stress", errors.guaranteed ? "<=" : "~", *errors.meanStress,
                                  errors.meanStressRelative, "error of the mean of computed and equilibrated stress")
                           : "";
}

std::string referenceText(const ReferenceSummary& reference)
{
  std::string remark = fmt::format("against h/{}, {} dofs", 1 << reference.refinements, grouped(reference.dofs));
  if (!reference.note.empty())
    remark += fmt::format(" ({})", reference.note);
  if (reference.effectivity)
    remark += fmt::format("; the bound is {:.3f} times it", *reference.effectivity);
  std::string text = line("reference", "=", reference.displacement, reference.relative, remark);
  if (reference.meanStress)
    text += line("  mean stress", "=", *reference.meanStress, {},
                 reference.meanStressEffectivity
                     ? fmt::format("its bound is {:.3f} times it", *reference.meanStressEffectivity)
                     : "");
  return text;
}

std::string comparisonsText(const ErrorSummary& errors)
{
  std::string text;
  if (errors.zienkiewiczZhu)
    text += line("Zienkiewicz-Zhu", "~", *errors.zienkiewiczZhu, {}, "a comparison, not guaranteed");
  if (errors.residual)
    text += line("residual", "~", *errors.residual, {}, "a comparison, not guaranteed");
  if (errors.equilibrium)
    text += fmt::format("\n  equilibrium of the recovered stress checked: largest defect {:.1e}", *errors.equilibrium);
  if (errors.equilibriumDiscretization)
    text += fmt::format("\n  equilibrium of the indicator's stress checked: largest defect {:.1e}",
                        *errors.equilibriumDiscretization);
  return text;
}

} // namespace

std::string errorText(const ErrorSummary& errors)
{
  const std::string text = boundText(errors) + partsText(errors) + meanStressText(errors) +
                           (errors.reference ? referenceText(*errors.reference) : "") + comparisonsText(errors);
  return text.substr(1);
}

} // namespace ndframe
