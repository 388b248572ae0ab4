#pragma once

#include <string>

#include "ndframe/io/summary.hpp"

namespace ndframe
{

/// The certificate in words: the bound and what it is worth, its parts with the advice, the comparisons.
std::string errorText(const ErrorSummary& errors);

} // namespace ndframe
