#pragma once

#include <functional>
#include <map>
#include <string>

#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// What gmsh has made of scripts while the meshes of one scene are read, so that bodies of one file share one run.
/// Counts "scripts meshed". Kept no longer than that: files may change from one scene to the next.
class ScriptMeshes
{
public:
  explicit ScriptMeshes(Ledger& ledger) : ledger_(ledger) {} ///< it must outlive this

  /// What `make` returned when it was first called for this script, meshed in this way.
  const std::string& find(const std::string& scriptAndWay, const std::function<std::string()>& make)
  {
    const auto known = texts_.find(scriptAndWay);
    if (known != texts_.end())
      return known->second;
    const std::string& made = texts_[scriptAndWay] = make();
    ledger_.count("scripts meshed");
    return made;
  }

private:
  Ledger& ledger_;
  std::map<std::string, std::string> texts_;
};

} // namespace ndframe
