#pragma once

#include <string>
#include <vector>

#include "ndframe/base/list_place.hpp"

namespace ndframe
{

/// An entry of Output/Probes, read: a point, a line or a side. What the deck does not give is empty.
struct ProbeOptions
{
  ListPlace place; ///< for mistakes that show later
  /// Name of the entry.
  std::string name, body; ///< name of a body of the deck
  std::vector<double> at; ///< coordinates of a point
  /// Where a line begins.
  std::vector<double> from, to; ///< where it ends
  int points = 0;               ///< of a line
  std::string side;             ///< of the body's mesh
  std::vector<double> about;    ///< of a side
  double tolerance = 0.0;       ///< relative to the body's diameter

  bool isLine() const { return !from.empty(); } ///< else a point or a side
  /// Where values are wanted; none for a side.
  std::vector<std::vector<double>> wanted() const;
};

} // namespace ndframe
