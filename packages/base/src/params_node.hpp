#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/params.hpp"

namespace Teuchos
{
class ParameterList;
}

namespace ndframe
{

/// One key of a validated list.
struct ParamsEntry
{
  std::string name;
  Kind kind;
  Value value;
  bool isGiven; ///< by the user; else it is the default
  std::string file;
  int line;
};

/// One validated list. Optional keys that were not given have no entry, lists that are not wanted no node.
struct Params::Node
{
  std::string name;
  std::string path;
  std::string file; ///< of the list, or of the nearest list around it that was given
  int line = 0;
  std::vector<ParamsEntry> entries;
  std::vector<std::shared_ptr<const Node>> lists;
};

/// The node as Teuchos sees it.
Teuchos::ParameterList toTeuchos(const Params::Node& node);

} // namespace ndframe
