#pragma once

#include <stdexcept>

namespace ndframe
{

/// Sides of solids cannot be cut at each other, for a reason that lies in their meshes and not in the code. what() is
/// the reason.
class CannotCut : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace ndframe
