#pragma once

#include <string>

#include "ndframe/base/expression_tree.hpp"

namespace ndframe
{

/// Adds the operations of `text` to a tree and returns the place of the whole; std::invalid_argument for what is not
/// known.
int parseExpression(const std::string& text, ExpressionTree& tree);

} // namespace ndframe
