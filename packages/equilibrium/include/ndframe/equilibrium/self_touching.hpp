#pragma once

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

} // namespace ndframe
