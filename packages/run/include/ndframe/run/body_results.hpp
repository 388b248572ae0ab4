#pragma once

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// What the summary says of the bodies of a solved run: energies, extremes, loads, reactions. Collective.
void completeBodies(Run& run, const Comm& comm);

/// Screen: energy, largest displacement and largest strain of every body.
std::string bodyTable(const RunSummary& summary, std::size_t nameWidth);

/// Screen: the forces on every body by loads, supports and contact.
std::string forceTable(const RunSummary& summary, std::size_t nameWidth);

} // namespace ndframe
