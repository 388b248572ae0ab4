#include "ndframe/scene/scene_settings.hpp"

#include <algorithm>

#include "ndframe/base/expression.hpp"

namespace ndframe
{
namespace
{

std::vector<Params> subsOf(const Params& list, const char* name)
{
  return list.hasSub(name) ? list.sub(name).subs() : std::vector<Params>();
}

std::string textOf(const Params& list, const char* name)
{
  return list.hasSub(name) ? toXml(list.sub(name)) : std::string();
}

RegionSettings readRegion(const Params& list)
{
  return {ListPlace(list), list.name(), list.get<std::vector<std::string>>("Cells"), list.sub("Material")};
}

/// Mesh and Material, and the others where there is something in them.
std::vector<ListPlace> idleLists(const Params& body)
{
  std::vector<ListPlace> lists;
  for (const char* list : {"Mesh", "Material"})
    if (body.hasSub(list))
      lists.emplace_back(body.sub(list));
  for (const char* list : {"Regions", "Supports", "Loads"})
    if (!subsOf(body, list).empty())
      lists.emplace_back(body.sub(list));
  return lists;
}

bool namesCells(const Params& load)
{
  return load.has("Cells") && !load.get<std::vector<std::string>>("Cells").empty();
}

BodySettings readBody(const Params& list)
{
  BodySettings body;
  body.place = ListPlace(list);
  body.name = list.name();
  body.isRigid = list.hasSub("Rigid");
  body.shape = list.sub(body.isRigid ? "Rigid" : "Mesh");
  if (body.isRigid)
    body.idle = idleLists(list);
  if (list.hasSub("Material"))
    body.material = list.sub("Material");
  body.hasRegions = list.hasSub("Regions");
  for (const Params& region : subsOf(list, "Regions"))
    body.regions.push_back(readRegion(region));
  body.supports = subsOf(list, "Supports");
  body.loads = subsOf(list, "Loads");
  body.namesCells = body.hasRegions || std::any_of(body.loads.begin(), body.loads.end(), namesCells);
  body.materialText = textOf(list, "Material") + textOf(list, "Regions") + textOf(list, "Rigid");
  body.supportText = textOf(list, "Supports");
  body.loadText = textOf(list, "Loads");
  return body;
}

InterfaceSettings readInterface(const Params& list)
{
  InterfaceSettings settings;
  settings.place = ListPlace(list);
  settings.name = list.name();
  settings.dirichletBody = list.get<std::string>("Dirichlet Body");
  settings.neumannBody = list.get<std::string>("Neumann Body");
  settings.dirichletSide = list.get<std::string>("Dirichlet Side");
  if (list.has("Neumann Side"))
    settings.neumannSide = list.get<std::string>("Neumann Side");
  settings.isTied = list.get<bool>("Tied");
  settings.gap = list.expression("Gap").text();
  settings.drawnGap = drawnGapNames().value(list.get<std::string>("Gap From Geometry"));
  settings.cornerAngle = list.get<double>("Corner Angle");
  settings.pairing = ListPlace(list.sub("Pairing"));
  settings.isMortar = list.sub("Pairing").get<std::string>("Type") == "Mortar";
  return settings;
}

} // namespace

const Names<DrawnGap>& drawnGapNames()
{
  static const Names<DrawnGap> names{{"Automatic", DrawnGap::Automatic}, {"Yes", DrawnGap::Yes}, {"No", DrawnGap::No}};
  return names;
}

const Params& BodySettings::materialOf(const std::string& region) const
{
  if (region.empty())
    return *material;
  const auto found = std::find_if(regions.begin(), regions.end(), [&](const auto& r) { return r.name == region; });
  NDFRAME_ASSERT(found != regions.end(), "a region of the body");
  return found->material;
}

const InterfaceSettings& SceneSettings::interface(const std::string& name) const
{
  const auto found = std::find_if(interfaces.begin(), interfaces.end(), [&](const auto& i) { return i.name == name; });
  NDFRAME_ASSERT(found != interfaces.end(), "an interface of the scene");
  return *found;
}

SceneSettings readScene(const Params& deck)
{
  const Params discretization = deck.sub("Discretization"), bodies = deck.sub("Bodies");
  const Params interfaces = deck.sub("Interfaces");
  SceneSettings scene;
  scene.discretization = ListPlace(discretization);
  scene.bodiesPlace = ListPlace(bodies);
  scene.interfacesPlace = ListPlace(interfaces);
  scene.order = discretization.get<int>("Order");
  const auto conditions = discretization.get<std::string>("Contact Conditions");
  if (conditions != "Automatic")
    scene.conditions = conditions == "Bernstein" ? ContactConditions::Bernstein : ContactConditions::Nodal;
  for (const Params& body : bodies.subs())
    scene.bodies.push_back(readBody(body));
  for (const Params& interface : interfaces.subs())
    if (interface.has("Dirichlet Body")) // Automatic is no interface
      scene.interfaces.push_back(readInterface(interface));
  scene.linearSolver = deck.sub("Linear Solver");
  scene.interfaceOperator = deck.sub("Interface Operator");
  scene.certifies = deck.hasSub("Error Estimation");
  scene.hasTarget = deck.hasSub("Accuracy");
  scene.discretizationText = toXml(discretization);
  scene.interfacesText = toXml(interfaces);
  return scene;
}

} // namespace ndframe
