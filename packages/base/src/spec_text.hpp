#pragma once

#include <string>
#include <vector>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// What help says of a parameter: {"double", "default 0.5", "in (0, 2)"}.
std::vector<std::string> paramFacts(const ParamSpec& param);

/// "required", "optional" or "only if given".
std::string presence(const ListSpec& list);

/// "double", or "number or expression in x, y, z".
std::string kindText(Kind kind);

/// "0.5", "required" or "optional": what stands for a parameter that the user does not write.
std::string defaultText(const ParamSpec& param);

/// True for ranges such as "(0, 2)".
bool isInterval(const Range& range);

/// What a parameter takes besides its kind: "in (0, 2)", ">= 1", "Right | Crossed"; empty for anything.
std::string rangeText(const Range& range);

} // namespace ndframe
