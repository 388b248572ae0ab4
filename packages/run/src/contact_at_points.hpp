#pragma once

#include <optional>
#include <vector>

#include "ndframe/condensation/contact_node.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// A place on an interface: nodes of the contact table and their weights there.
struct ContactPlace
{
  std::vector<std::size_t> nodes;
  std::vector<double> weights;

  /// sum weights * values at the nodes.
  double value(const std::vector<ContactNode>& contact, double ContactNode::*values) const;
};

/// Where a point of a body lies on an interface of it, within `tolerance` (a length); at a corner of several interfaces
/// the place on each, at most one an interface. Empty for a point on none.
std::vector<ContactPlace> contactPlaces(const Model& model, int body, const std::vector<double>& point,
                                        double tolerance);

} // namespace ndframe
