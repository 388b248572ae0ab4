#pragma once

#include <optional>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// A mesh that hangs together in a single point only; the user's mistake.
class SelfTouching : public InputError
{
public:
  SelfTouching(const BodyModel& model, int touching);
  /// Found by another rank.
  SelfTouching(const std::string& body, int dim, const Direction& point);
  int vertex; ///< -1: of another rank
};

/// Throws where a rank has found a vertex of its own part: that with the least coordinates. Collective.
void refuseTouching(const BodyModel& part, const std::optional<int>& vertex, const Comm& comm);

} // namespace ndframe
