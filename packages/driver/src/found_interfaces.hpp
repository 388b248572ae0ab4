#pragma once

#include "ndframe/base/log.hpp"
#include "ndframe/driver/components.hpp"
#include "ndframe/run/run_settings.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Settings of a deck whose Interfaces/Automatic has given way to the interfaces that it found on the deck's meshes,
/// with table and deck text on the screen. model: an earlier (or empty) one; it has these meshes afterwards, so that
/// they are not read again. Settings without the list stay as they are, and so does the model. Throws InputError:
/// bodies in space; names of Leave Out that do not exist; no interface at all, with the nearest sides.
RunSettings withFoundInterfaces(const RunSettings& settings, const Components& components, Model& model,
                                const Comm& comm, Ledger& ledger, const Log& log);

} // namespace ndframe
