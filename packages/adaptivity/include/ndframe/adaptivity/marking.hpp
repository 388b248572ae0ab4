#pragma once

#include <cstdint>
#include <optional>

#include "ndframe/adaptivity/contribution_model.hpp"
#include "ndframe/adaptivity/size_field.hpp"
#include "ndframe/base/registry.hpp"

namespace ndframe
{

/// Decides from contributions where cells shall be smaller, and how small.
class Marking
{
public:
  virtual ~Marking() = default;

  /// Sizes for sqrt(sum eta_K^2) = target. Markings that cannot aim make a step of their own length.
  virtual SizeField sizes(const ContributionModel& model, double target) const = 0;

  /// Cells that a mesh with this error will have, without what conformity adds; none without a prediction.
  virtual std::optional<std::int64_t> cellsFor(const ContributionModel& model, double target) const = 0;
};

/// "Predicted" (default), "Doerfler" (parameter Fraction), "Uniform".
void registerMarkings(Registry<Marking>& registry);

} // namespace ndframe
