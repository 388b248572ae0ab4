#pragma once

#include <optional>
#include <string>

#include "ndframe/base/list_place.hpp"

namespace ndframe
{

/// Whether the drawn distance between the sides is part of the gap; Automatic: unless the sides touch.
enum class DrawnGap
{
  Automatic,
  Yes,
  No
};

/// An entry of Interfaces, read (readScene).
struct InterfaceSettings
{
  ListPlace place, pairing; ///< for mistakes that show later; pairing: list Pairing
  std::string name;
  std::string dirichletBody, neumannBody;
  std::string dirichletSide;
  std::optional<std::string> neumannSide; ///< a rigid body has none
  bool isTied = false;                    ///< the bodies are one (tied_deck.hpp) before a scene is built
  std::string gap = "0";                  ///< an expression that parses: opening along n_c, a length
  DrawnGap drawnGap = DrawnGap::Automatic;
  double cornerAngle = 0.0; ///< degrees: at a smaller one facets are of a curve
  bool isMortar = false;    ///< contact in weighted means
};

} // namespace ndframe
