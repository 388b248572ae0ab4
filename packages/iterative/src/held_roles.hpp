#pragma once

#include "ndframe/algebra/ghosts.hpp"
#include "ndframe/algebra/rank_problem.hpp"

namespace ndframe
{

/// Per dof of a node that this rank holds whether it is Interior or Fixed, ghosts as their owners say. isInterior: per
/// own dof. Collective.
inline std::vector<DofRole> heldRoles(const IndexMap& nodes, int dim, const std::vector<char>& isInterior,
                                      const Comm& comm)
{
  const auto width = std::size_t(dim);
  Vector values(std::size_t(nodes.size()) * width, 0.0);
  std::copy(isInterior.begin(), isInterior.end(), values.begin());
  sharedGhosts(nodes, comm)
      .fetch(
          [width](int node) {
            return SharedValues::Place{std::size_t(node) * width, width};
          },
          values);
  std::vector<DofRole> roles;
  roles.reserve(values.size());
  for (const double value : values)
    roles.push_back(value != 0.0 ? DofRole::Interior : DofRole::Fixed);
  return roles;
}

} // namespace ndframe
