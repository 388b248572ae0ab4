#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "ndframe/scene/scene_settings.hpp"

namespace ndframe
{

/// Where grid lines of a plane box must be besides its ends, per direction; ascending.
using Stations = std::array<std::vector<double>, 2>;

/// The grid lines that the boxes of a scene need, by body: where a side is cut into parts, and where a box that it
/// touches needs one, directly or through others. With a cell between any two of them all sides match. Other meshes
/// and turned boxes have none.
std::map<std::string, Stations> matchingStations(const SceneSettings& scene);

} // namespace ndframe
