#pragma once

#include <string>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Why two roles do not suffice: the bodies of a ring of odd length, by name. Empty where there is none.
std::string oddRing(const Model& model);

} // namespace ndframe
