#pragma once

#include <vector>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The place of every body among those that are meshed; -1 for rigid ones.
inline std::vector<int> placesOf(const Model& model)
{
  std::vector<int> places(model.bodies.size(), -1);
  int next = 0;
  for (const int b : model.elasticBodies())
    places[std::size_t(b)] = next++;
  return places;
}

} // namespace ndframe
