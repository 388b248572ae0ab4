#pragma once

#include <functional>
#include <memory>

#include "ndframe/accuracy/accuracy_components.hpp"

namespace ndframe
{

/// All components a deck can name, a group for each package that builds them.
struct Components final : AccuracyComponents
{};

/// Adds components of another project: called before those that build on others (couplings use relaxations).
using Extension = std::function<void(Components&)>;

/// Registers everything that ndframe ships, and the extension's components.
std::unique_ptr<Components> makeComponents(const Extension& extend = {});

} // namespace ndframe
