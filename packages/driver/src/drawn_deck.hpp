#pragma once

#include <string>
#include <vector>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// A deck, and what --check says against it.
struct DrawnDeck
{
  std::string text;
  std::vector<Diagnostic> mistakes; ///< empty: it runs
};

/// A deck of what is drawn in a .geo or .msh file of gmsh: its physical groups of cells are the bodies, those of the
/// boundary the sides. output: file of the deck, from whose folder the drawing is named.
///
/// What the drawing does not say is guessed, and the deck says so: sides that face each other touch (in space those
/// that both bodies have), flat sides that several bodies have by one name are planes of symmetry, the lowest body is
/// clamped on the side away from contact, and the others are moved against what they touch. A Hold that turns out to
/// have nothing to hold is left out. Throws InputError for files that cannot be read, bodies that meet nothing, and a
/// scene without a side to hold.
DrawnDeck drawnDeck(const std::string& drawing, const std::string& output, const Components& components);

} // namespace ndframe
