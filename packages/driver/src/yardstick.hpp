#pragma once

#include <string>

#include "ndframe/algebra/yardstick.hpp"
#include "ndframe/driver/components.hpp"
#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// --yardstick: what the libraries alone need for the bodies of a deck (algebra/yardstick.hpp), one after the other, as
/// a table with their sum. Writes NAME.yardstick.json to the deck's output folder, by body and "all":
/// {"dofs", "nonzeros", "flops", "order", "factor", "solve", "total"}, the times as {"wall", "processor"} in seconds.
/// Refuses to run on several ranks (InputError).
std::string yardstickText(const RunSettings& settings, const Components& components, const std::string& deckName,
                          const Comm& comm);

} // namespace ndframe
