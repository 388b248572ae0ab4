#pragma once

#include <string>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// Text for `--help LIST`: the list (or component) found by its name or path, its keys with kind, default, range and
/// documentation, its sublists and components. Unknown names are answered with an InputError naming the nearest.
std::string helpText(const ListSpec& deck, const std::string& listName);

/// All components of all lists, one line each, grouped by list path; for `--list`.
std::string componentList(const ListSpec& deck);

/// The whole reference as Markdown; `docs/reference.md` is this text.
std::string referenceMarkdown(const ListSpec& deck);

/// The candidate closest to `name` in edit distance if it is close enough to be a misspelling, else empty.
std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

} // namespace ndframe
