#include "ndframe/certification/advice.hpp"

#include <cmath>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

constexpr double negligible = 0.5; ///< an iteration part below this share of the mesh's hardly shows in their sum
constexpr double harmless = 1e-6;  ///< relative errors below this need no advice

/// The iteration's part in the error is about eps_tau where all forces pass through the interface, and less elsewhere.
/// What is clearly more is no matter of sweeps: the mesh does not resolve the end of the contact.
constexpr double explained = 3.0;

/// Relative to the solution's energy norm.
struct Parts
{
  double mesh = 0.0, iteration = 0.0;
};

std::optional<Parts> partsOf(const ErrorSummary& errors)
{
  if (!errors.algorithm)
    return std::nullopt;
  if (errors.discretization)
    return Parts{errors.discretization->relative, errors.algorithm->relative};
  if (errors.splitStress && errors.global && errors.global->absolute > 0.0)
    return Parts{*errors.splitStress * errors.global->relative / errors.global->absolute, errors.algorithm->relative};
  return std::nullopt;
}

/// "2 more sweeps", many of them in steps of 5, or without a number when the last two do not tell.
std::string sweepsToGo(const Parts& parts, const std::vector<SweepRecord>& history)
{
  const auto last = history.rbegin();
  const double contraction = history.size() < 2 ? 1.0 : last[0].epsTau / last[1].epsTau;
  if (!(contraction > 0.0 && contraction < 1.0))
    return "more sweeps";
  constexpr double few = 10.0, step = 5.0;
  double sweeps = std::ceil(std::log(negligible * parts.mesh / parts.iteration) / std::log(contraction));
  if (sweeps > few)
    sweeps = step * std::ceil(sweeps / step);
  return std::isfinite(sweeps) ? fmt::format("{:.0f} more sweep{}", sweeps, sweeps == 1.0 ? "" : "s") : "more sweeps";
}

} // namespace

std::string advice(const ErrorSummary& errors, const std::vector<SweepRecord>& history)
{
  const auto parts = partsOf(errors);
  if (!parts || parts->mesh + parts->iteration < harmless || history.empty())
    return {};
  if (parts->iteration <= negligible * parts->mesh)
    return "a finer mesh would help, more sweeps would not";
  if (errors.algorithm->projection > negligible * errors.algorithm->absolute) // one traction for both bodies: FETI
    return meshDominates(errors) ? "a finer mesh and a smaller Coupling/Tolerance would help"
                                 : "a smaller Coupling/Tolerance would leave the mesh alone";
  if (parts->iteration > explained * history.back().epsTau)
    return "a finer mesh where contact ends would help, more sweeps would not";
  const auto sweeps = sweepsToGo(*parts, history);
  return meshDominates(errors) ? fmt::format("a finer mesh and {} would help", sweeps)
                               : fmt::format("{} would leave the mesh alone", sweeps);
}

bool meshDominates(const ErrorSummary& errors)
{
  const auto parts = partsOf(errors);
  return parts && parts->mesh >= parts->iteration;
}

} // namespace ndframe
