#pragma once

#include <string>

#include "ndframe/run/run_summary.hpp"

namespace ndframe
{

/// The certificate in words: the bound and what it is worth, its parts with the advice, the comparisons.
std::string errorText(const ErrorSummary& errors);

/// The exact energy in its bracket, and what follows from it.
std::string energyText(const EnergySummary& summary);

} // namespace ndframe
