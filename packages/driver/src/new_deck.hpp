#pragma once

#include <string>

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

/// Writes the deck and returns its file. Throws InputError: a template that does not exist, with those that do; a file
/// that is there already and is not to be replaced; what from-geo cannot read or make a scene of.
std::string writeNewDeck(const NewDeck& wanted, const Components& components);

/// Names of the templates.
std::vector<std::string> templateNames();

/// The end of `ndframe new --help`: what each template is.
std::string templateHelp();

} // namespace ndframe
