#pragma once

#include <string>
#include <vector>

#include "ndframe/base/list_place.hpp"

namespace ndframe
{

/// An entry of Output/Probes, read: a point, a line or a side. What the deck does not give is empty.
struct ProbeOptions
{
  ListPlace place;
  std::string name, body;
  std::vector<double> at;
  std::vector<double> from, to;
  int points = 0; ///< of a line
  std::string side;
  std::vector<double> about; ///< of a side
  double tolerance = 0.0;    ///< relative to the body's diameter

  bool isLine() const { return !from.empty(); }
  /// Where values are wanted; none for a side.
  std::vector<std::vector<double>> wanted() const;
};

} // namespace ndframe
