#pragma once

#include <functional>
#include <memory>

#include "ndframe/driver/components.hpp"

namespace ndframe::test
{

/// Where the components "Failing" fail: on a level of a run with a target, counted from 1, once.
struct PlannedFailure
{
  int level = 0;
  std::function<void()> fail; ///< throws
};

/// Everything ndframe ships, and of linear solvers, recoveries and refinements one called "Failing": the default one,
/// which fails as planned. A new run begins with a new plan.
const Components& failingComponents(const PlannedFailure& plan);

} // namespace ndframe::test
