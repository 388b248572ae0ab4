#include "ndframe/certification/energy_records.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ndframe
{

SceneIdentity::SceneIdentity(const SceneSettings& scene, const Model& model) : data_(scene.interfacesText)
{
  for (const BodySettings& body : scene.bodies)
    data_ += body.name + body.materialText + body.supportText + body.loadText;
  for (const int b : model.elasticBodies()) // meshes of the others follow theirs
    bodies_.push_back(model.told ? model.told->outlines[std::size_t(b)] : outlineOf(model.bodies[std::size_t(b)].mesh));
}

bool SceneIdentity::operator==(const SceneIdentity& other) const
{
  return data_ == other.data_ &&
         std::equal(bodies_.begin(), bodies_.end(), other.bodies_.begin(), other.bodies_.end(), sameOutline);
}

EnergyRecord& EnergyRecords::of(SceneIdentity scene)
{
  const auto known =
      std::find_if(records_.begin(), records_.end(), [&](const auto& entry) { return entry.first == scene; });
  if (known != records_.end())
    return known->second;
  records_.emplace_back(std::move(scene), EnergyRecord());
  return records_.back().second;
}

std::string EnergyRecords::name(int level) const
{
  const std::string ofLevel = level > 0 ? fmt::format("level {}", level) : std::string();
  if (run_.empty())
    return ofLevel.empty() ? "this run" : ofLevel;
  return ofLevel.empty() ? run_ : run_ + ", " + ofLevel;
}

} // namespace ndframe
