#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// The completion script of "bash", "zsh" or "fish", made of the options and the deck's specification. Throws
/// InputError for another shell.
std::string completionScript(const std::string& shell, const CLI::App& app, const ListSpec& deck);

/// A word, such as a file's name, as one types it: in quotes where a shell would take it for several.
std::string forShell(const std::string& word);

/// The manual page ndframe(1), in roff.
std::string manualPage(const CLI::App& app);

} // namespace ndframe
