#pragma once

#include <string>
#include <vector>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// Text for `--help WORD`: the list (or component) found by its name or path, its keys with kind, default, range and
/// documentation, its sublists and components; capitals and plurals do not matter where no name is exactly the word.
/// Other words: where they are named. What is found nowhere is answered with an InputError naming the nearest list.
std::string helpText(const ListSpec& deck, const std::string& listName);

/// What comes nearest to something that ndframe does not do ("friction", "Friction Coefficient"), one sentence; empty
/// for other words. docs/limits.md has the same list.
std::string limitOf(const std::string& words);

/// What helpText() finds by name: lists and components, each once, in the order of the specification.
std::vector<std::string> listAndComponentNames(const ListSpec& deck);

/// Paths of all parameters that stand in no list that the user names, such as "Coupling/Stopping/Tolerance".
std::vector<std::string> parameterPaths(const ListSpec& deck);

/// All components of all lists, one line each, grouped by list path; for `--list`.
std::string componentList(const ListSpec& deck);

/// The whole reference as Markdown; `docs/reference.md` is this text.
std::string referenceMarkdown(const ListSpec& deck);

/// The candidate closest to `name` in edit distance if it is close enough to be a misspelling, else empty.
std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

} // namespace ndframe
