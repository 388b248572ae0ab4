#pragma once

#include <nlohmann/json.hpp>

#include "ndframe/io/summary.hpp"

namespace ndframe
{

using Json = nlohmann::ordered_json;

/// The certificate; null without one. What was not computed is null.
Json errorsJson(const std::optional<ErrorSummary>& errors);

} // namespace ndframe
