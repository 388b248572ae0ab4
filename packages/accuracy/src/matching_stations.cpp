#include "matching_stations.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ndframe
{
namespace
{

constexpr double samePlace = 1e-9; ///< relative to a box's length

/// A part of a box's side: from `first` to `last` along a direction.
struct Part
{
  int along;
  double first, last;
};

/// An unturned box of the plane, as the deck describes it.
class PlaneBox
{
public:
  explicit PlaneBox(const Params& mesh)
      : lower_(mesh.get<std::vector<double>>("Lower")), upper_(mesh.get<std::vector<double>>("Upper"))
  {
    for (const char* side : {"left", "right"})
      parts_[side] = {1, lower_[1], upper_[1]};
    for (const char* side : {"bottom", "top"})
      parts_[side] = {0, lower_[0], upper_[0]};
    for (const Params& split : mesh.sub("Splits").subs())
      cut(split);
    if (mesh.hasSub("Parts"))
      for (const Params& part : mesh.sub("Parts").subs())
        for (const char* corner : {"Lower", "Upper"})
          takeCorner(part.get<std::vector<double>>(corner));
  }

  std::optional<Part> part(const std::string& name) const
  {
    const auto found = parts_.find(name);
    return found == parts_.end() ? std::nullopt : std::optional(found->second);
  }

  const Stations& stations() const { return stations_; }

  /// Adds those that lie inside the part; true when one is new.
  bool take(const Part& part, const std::vector<double>& stations)
  {
    auto& mine = stations_[std::size_t(part.along)];
    const double near = samePlace * (upper_[std::size_t(part.along)] - lower_[std::size_t(part.along)]);
    const std::size_t before = mine.size();
    for (const double x : stations) {
      const bool isKnown = std::any_of(mine.begin(), mine.end(), [&](double y) { return std::abs(x - y) <= near; });
      if (!isKnown && x > part.first + near && x < part.last - near)
        mine.push_back(x);
    }
    std::sort(mine.begin(), mine.end());
    return mine.size() > before;
  }

private:
  /// Of a part of the box: grid lines go through it.
  void takeCorner(const std::vector<double>& corner)
  {
    for (std::size_t d = 0; d < 2 && corner.size() == 2; ++d)
      take({int(d), lower_[d], upper_[d]}, {corner[d]});
  }

  void cut(const Params& split)
  {
    const auto whole = part(split.get<std::string>("Side"));
    auto at = split.get<std::vector<double>>("At");
    const auto names = split.get<std::vector<std::string>>("Names");
    if (!whole || names.size() != at.size() + 1)
      return; // a mistake, which the mesh reports
    take(*whole, at);
    at.insert(at.begin(), whole->first);
    at.push_back(whole->last);
    for (std::size_t k = 0; k < names.size(); ++k)
      parts_[names[k]] = {whole->along, at[k], at[k + 1]};
  }

  std::vector<double> lower_, upper_;
  std::map<std::string, Part> parts_;
  Stations stations_;
};

std::map<std::string, PlaneBox> planeBoxes(const SceneSettings& scene)
{
  std::map<std::string, PlaneBox> boxes;
  for (const BodySettings& body : scene.bodies) {
    if (body.isRigid)
      continue;
    const Params& mesh = body.shape;
    if (mesh.get<std::string>("Type") == "Box" && mesh.get<std::vector<double>>("Lower").size() == 2 &&
        mesh.get<std::vector<double>>("Upper").size() == 2 && mesh.get<double>("Rotation") == 0.0)
      boxes.emplace(body.name, PlaneBox(mesh));
  }
  return boxes;
}

/// Gives each of two touching boxes the other's grid lines; true when one is new.
bool exchange(const InterfaceSettings& interface, std::map<std::string, PlaneBox>& boxes)
{
  const auto one = boxes.find(interface.dirichletBody);
  const auto other = boxes.find(interface.neumannBody);
  if (one == boxes.end() || other == boxes.end())
    return false;
  if (!interface.neumannSide) // a mistake, which reading the interface tells
    return false;
  const auto onePart = one->second.part(interface.dirichletSide);
  const auto otherPart = other->second.part(*interface.neumannSide);
  if (!onePart || !otherPart || onePart->along != otherPart->along)
    return false;
  const auto along = std::size_t(onePart->along);
  const bool changes = one->second.take(*onePart, other->second.stations()[along]);
  return other->second.take(*otherPart, one->second.stations()[along]) || changes;
}

} // namespace

std::map<std::string, Stations> matchingStations(const SceneSettings& scene)
{
  auto boxes = planeBoxes(scene);
  for (bool changes = true; changes;) {
    changes = false;
    for (const InterfaceSettings& interface : scene.interfaces)
      changes = exchange(interface, boxes) || changes;
  }
  std::map<std::string, Stations> stations;
  for (const auto& [name, box] : boxes)
    stations[name] = box.stations();
  return stations;
}

} // namespace ndframe
