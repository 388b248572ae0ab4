#pragma once

#include <string>

#include "ndframe/drawing/drawn_scene.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// Reads the drawing and finds what touches and what is a plane of symmetry. deckFile: where the deck will be; drawing
/// as the deck names it. Throws InputError as drawnDeck() does.
DrawnAssembly readDrawing(const std::string& drawing, const std::string& deckFile, const Components& components);

} // namespace ndframe
