#pragma once

#include <string>
#include <vector>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// What `ndframe new` is asked for.
struct NewDeck
{
  std::string name;    ///< of the template
  std::string drawing; ///< a .geo or .msh file, for from-geo
  std::string output;  ///< empty: NAME.xml, or like the drawing, in the working directory
  bool replace = false;
};

/// The file of a deck that was written, and what --check says against it (of from-geo).
struct WrittenDeck
{
  std::string file;
  std::vector<Diagnostic> mistakes;
};

/// Writes the deck. Throws InputError: a template that does not exist, with those that do; a file
/// that is there already and is not to be replaced; what from-geo cannot read or make a scene of.
WrittenDeck writeNewDeck(const NewDeck& wanted, const Components& components);

/// "wrote X.xml; run it: ndframe X.xml", or that it does not run yet.
std::string writtenText(const WrittenDeck& deck);

/// Throws InputError for a drawing in the place of a deck: how a deck is made of it.
void refuseDrawing(const std::string& deck);

/// Names of the templates.
std::vector<std::string> templateNames();

/// The end of `ndframe new --help`: what each template is.
std::string templateHelp();

} // namespace ndframe
