#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Numbers of the vertices of some bodies: one for those that touch each other.
struct JoinedVertices
{
  std::vector<std::vector<int>> numbers; ///< per body and vertex of its mesh, from 0 on
  int count = 0;                         ///< of different numbers

  int operator()(std::size_t body, int vertex) const { return numbers[body][std::size_t(vertex)]; }
};

/// bodies: by their numbers in the model; the result has them in this order. Numbers are in the order of the bodies and
/// their vertices, each that of the first that has it.
JoinedVertices joinedVertices(const Model& model, const std::vector<int>& bodies);

} // namespace ndframe
