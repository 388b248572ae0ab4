#pragma once

#include <string>

#include "ndframe/run/run_summary.hpp"

namespace ndframe
{

/// Energy, largest displacement and largest strain of every body.
std::string bodyTable(const RunSummary& summary, std::size_t nameWidth);

/// The forces on every body by loads, supports and contact.
std::string forceTable(const RunSummary& summary, std::size_t nameWidth);

} // namespace ndframe
