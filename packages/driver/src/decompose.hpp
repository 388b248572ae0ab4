#pragma once

#include <string>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/driver/components.hpp"
#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// Reads the meshes of a deck's elastic bodies and writes each as pieces NAME.BODY.e.N.r, sides and groups with the
/// names that the deck uses. Pieces with one number belong to one part of the scene; of a body they may have no cells.
/// Returns what the screen says: the files, and the settings with which the deck reads them. deckName: the deck's file.
/// Throws InputError for groups that overlap, scenes with fewer cells than pieces and tied bodies. Collective; rank 0
/// writes.
std::string decompose(const RunSettings& settings, int pieces, const Components& components,
                      const std::string& deckName, const Comm& comm);

} // namespace ndframe
