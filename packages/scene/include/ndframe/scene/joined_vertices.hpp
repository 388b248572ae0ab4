#pragma once

#include <utility>

#include "ndframe/mesh/refined_numbers.hpp"
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

/// Two bodies that touch, perhaps the same, and the vertices of the first and of the second that do.
struct TouchingVertices
{
  std::size_t first = 0, second = 0;
  std::vector<std::pair<int, int>> pairs;
};

/// numVertices: per body. Numbers are in the order of the bodies and their vertices, each that of the first that has
/// it.
JoinedVertices joinedVertices(const std::vector<int>& numVertices, const std::vector<TouchingVertices>& touching);

/// bodies: by their numbers in the model; the result has them in this order.
JoinedVertices joinedVertices(const Model& model, const std::vector<int>& bodies);

/// Which of so many parts each vertex of some bodies belongs to, whose parts have about as many nodes: METIS on one
/// graph of all of them, in which joined vertices are one. meshes: of one dimension; numbers: of the meshes as they
/// will be refined. Per body and vertex.
std::vector<std::vector<int>> partitionJoined(const JoinedVertices& joined, const std::vector<const Mesh*>& meshes,
                                              const std::vector<const RefinedNumbers*>& numbers, int parts);

} // namespace ndframe
