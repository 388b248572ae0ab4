#pragma once

#include <string>

#include "certificate/drawn_scene.hpp"
#include "ndframe/driver/run_deck.hpp"

namespace ndframe::test
{

/// Writes the deck and its meshes into a folder, made if missing. Returns the deck's path.
std::string writeScene(const DrawnScene& scene, const std::string& folder);

/// Reads, checks and runs a deck; writes no results.
Run runDeckFile(const std::string& path);

} // namespace ndframe::test
