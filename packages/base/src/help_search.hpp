#pragma once

#include <string>
#include <vector>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// The name in lower case and in the singular: "Supports" and "support" are the same.
std::string helpStem(const std::string& name);

/// The parameters of this name, after the list or component that has it, too; empty when there is none.
std::string parametersNamed(const ListSpec& deck, const std::string& name);

/// What --help answers for words that name no list: parameters, lists and components with all of the words in their
/// names, then those with the words in their documentation, with their paths. Empty when there is none.
std::string searchHelp(const ListSpec& deck, const std::string& words);

/// The words that limitOf() (help.hpp) answers.
std::vector<std::string> limitWords();

} // namespace ndframe
