#pragma once

#include <optional>
#include <string>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// Teuchos' name of a kind: "bool", "Array(double)"; Kind::Expression is "expression".
const std::string& kindName(Kind kind);

/// The kind that a deck's attribute `type` names; empty for an unknown one.
std::optional<Kind> kindFromType(const std::string& type);

/// True when an entry written as `written` may stand where `wanted` is wanted.
bool accepts(Kind wanted, Kind written);

/// The value that `text` stands for. Throws std::invalid_argument with the reason, worded to follow the text:
/// "is not an int", "is not finite".
Value parseValue(Kind kind, const std::string& text);

/// The narrowest of bool, int, double, string that `text` can be; for entries without type that no spec knows.
Kind guessKind(const std::string& text);

/// The kind to write a value with.
Kind kindOf(const Value& value);

/// The value as a deck writes it: shortest text that reads back to the same number, arrays as "{1, 2}".
std::string valueText(const Value& value);

} // namespace ndframe
