#pragma once

#include <string>
#include <vector>

namespace ndframe
{

/// An interface that Interfaces/Automatic has found.
struct FoundInterface
{
  std::string name; ///< in the deck, "BODY SIDE - BODY SIDE"
  /// The first ones are the Dirichlet body and side, the second ones the Neumann body and side.
  std::string firstBody, firstSide, /**< of it */ secondBody, /**< may be the same */ secondSide; ///< of it
  double length = 0.0; ///< of the first side's part that faces the second one; an area in space
  /// A length; negative where polygons overlap.
  double smallest = 0.0, largest = 0.0; ///< opening there
};

/// The table of what was found within a distance.
std::string foundText(const std::vector<FoundInterface>& found, double distance);

/// The same of solids, whose sides lie on each other.
std::string matchingText(const std::vector<FoundInterface>& found);

} // namespace ndframe
