#include "ndframe/scene/regions.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/help.hpp"

namespace ndframe
{
namespace
{

constexpr int nowhere = -1;

/// The groups of cells that a region names; without any the one of its own name.
std::vector<std::string> groupsOf(const RegionSettings& region)
{
  return region.cells.empty() ? std::vector<std::string>{region.name} : region.cells;
}

/// Builds the law of a list Material and checks its hypothesis.
class Laws
{
public:
  Laws(const SceneComponents& components, int dim, Diagnostics& diagnostics)
      : components_(components), dim_(dim), diagnostics_(diagnostics)
  {}

  void add(const Params& material)
  {
    const auto law = components_.materials.build(material);
    const bool isSpatial = law->hypothesis() == Hypothesis::ThreeDimensional;
    const auto refuse = [&](const std::string& message) {
      diagnostics_.add(
          material.mistake("Hypothesis", fmt::format("\"{}\" {}", hypothesisNames().name(law->hypothesis()), message)));
    };
    if (isSpatial != (dim_ == 3))
      refuse(fmt::format("does not suit a mesh of dimension {}; use {}.", dim_,
                         isSpatial ? "Plane Strain or Plane Stress" : "Three Dimensional"));
    else if (!laws_.empty() && law->hypothesis() != first_)
      refuse(fmt::format("here, \"{}\" in another region; a body has one hypothesis.", hypothesisNames().name(first_)));
    if (laws_.empty())
      first_ = law->hypothesis();
    laws_.push_back(law->elasticity());
  }

  const std::vector<Elasticity>& all() const { return laws_; }

private:
  const SceneComponents& components_;
  int dim_;
  Diagnostics& diagnostics_;
  Hypothesis first_ = Hypothesis::PlaneStrain;
  std::vector<Elasticity> laws_;
};

/// Which region the kinds of cells belong to.
class KindsOfRegions
{
public:
  KindsOfRegions(const Mesh& mesh, Diagnostics& diagnostics)
      : mesh_(mesh), diagnostics_(diagnostics), region_(mesh.groups.names.size(), nowhere)
  {
    for (const auto& names : mesh.groups.names)
      names_.insert(names.begin(), names.end());
  }

  void add(const RegionSettings& region, int number)
  {
    const auto groups = groupsOf(region);
    for (const std::string& group : groups)
      if (names_.count(group) == 0)
        refuseUnknown(region, group);
    for (std::size_t kind = 0; kind < region_.size(); ++kind) {
      const auto& names = mesh_.groups.names[kind];
      const bool isMine = std::any_of(groups.begin(), groups.end(), [&](const std::string& group) {
        return std::binary_search(names.begin(), names.end(), group);
      });
      if (isMine && region_[kind] != nowhere)
        refuseShared(region, int(kind), others_[std::size_t(region_[kind])]);
      else if (isMine)
        region_[kind] = number;
    }
    others_.push_back(region.name);
  }

  /// Per cell: the region, or `rest`.
  std::vector<int> ofCells(int rest) const
  {
    std::vector<int> regions(std::size_t(mesh_.numCells()), rest);
    for (std::size_t c = 0; c < mesh_.groups.kind.size(); ++c)
      if (const int region = region_[std::size_t(mesh_.groups.kind[c])]; region != nowhere)
        regions[c] = region;
    return regions;
  }

private:
  void refuseUnknown(const RegionSettings& region, const std::string& group)
  {
    const std::vector<std::string> names(names_.begin(), names_.end());
    const std::string nearest = nearestName(group, names);
    diagnostics_.add(region.place.mistake(
        "Cells", fmt::format("the mesh has no group of cells \"{}\"; {}", group,
                             names.empty() ? "it names no groups (physical groups of gmsh, element blocks of Exodus, "
                                             "Parts of a box)."
                             : nearest.empty() ? fmt::format("its groups are: {}.", fmt::join(names, ", "))
                                               : fmt::format("did you mean \"{}\"?", nearest))));
  }

  void refuseShared(const RegionSettings& region, int kind, const std::string& other)
  {
    const auto cell = std::find(mesh_.groups.kind.begin(), mesh_.groups.kind.end(), kind) - mesh_.groups.kind.begin();
    if (cell == mesh_.numCells())
      return;
    diagnostics_.add(region.place.mistake(
        "Cells", fmt::format("contains the cell at {}, which region \"{}\" contains, too; a cell has one material.",
                             pointText(cellCentre(mesh_, int(cell)).data(), mesh_.dim), other)));
  }

  const Mesh& mesh_;
  Diagnostics& diagnostics_;
  std::set<std::string> names_;
  std::vector<int> region_; ///< per kind of cells
  std::vector<std::string> others_;
};

/// Counts the cells of the regions.
std::vector<BodyRegion> countCells(std::vector<std::string> names, const std::vector<int>& regionOfCell)
{
  std::vector<BodyRegion> regions;
  for (std::string& name : names)
    regions.push_back({std::move(name)});
  for (const int region : regionOfCell)
    ++regions[std::size_t(region)].numCells;
  return regions;
}

void refuseWithoutMaterial(const BodyModel& body, const BodySettings& settings, Diagnostics& diagnostics)
{
  const int rest = int(body.regions.size()) - 1;
  const auto first = std::find(body.regionOfCell.begin(), body.regionOfCell.end(), rest) - body.regionOfCell.begin();
  diagnostics.add(settings.place.mistake(
      "", fmt::format("{} of {} cells are in no region, the first at {}; give the body a list \"Material\" for them.",
                      body.regions.back().numCells, body.mesh.numCells(),
                      pointText(cellCentre(body.mesh, int(first)).data(), body.mesh.dim))));
}

/// Counts the cells of the regions of a whole body; a rest that has none is no region.
void findRegions(BodyModel& body, std::vector<std::string> names, const BodySettings& settings,
                 Diagnostics& diagnostics)
{
  body.regions = countCells(std::move(names), body.regionOfCell);
  for (std::size_t r = 0; r < settings.regions.size(); ++r)
    if (body.regions[r].numCells == 0 && diagnostics.empty())
      diagnostics.add(settings.regions[r].place.mistake("", "names no cells."));
  if (body.regions.back().numCells == 0)
    body.regions.pop_back();
  else if (!settings.material && diagnostics.empty())
    refuseWithoutMaterial(body, settings, diagnostics);
}

} // namespace

void takeMaterials(BodyModel& body, const BodySettings& settings, const SceneComponents& components,
                   const std::vector<BodyRegion>* whole, Diagnostics& diagnostics)
{
  Laws laws(components, body.mesh.dim, diagnostics);
  KindsOfRegions kinds(body.mesh, diagnostics);
  std::vector<std::string> names;
  for (const RegionSettings& region : settings.regions) {
    laws.add(region.material);
    kinds.add(region, int(names.size()));
    names.push_back(region.name);
  }
  if (settings.material)
    laws.add(*settings.material);
  if (laws.all().empty())
    throw InputError(settings.place.mistake("", "has neither a list \"Material\" nor regions."));
  if (settings.regions.empty()) {
    body.laws = laws.all().front();
    return;
  }
  const int rest = int(names.size());
  names.emplace_back();
  body.regionOfCell = kinds.ofCells(rest);
  if (whole != nullptr)
    body.regions = *whole;
  else
    findRegions(body, std::move(names), settings, diagnostics);
  if (!diagnostics.empty())
    return;
  std::vector<Elasticity> ofRegions = laws.all();
  ofRegions.resize(body.regions.size()); // a rest that is no region has none
  body.laws = CellLaws(ofRegions, body.regionOfCell);
  for (std::size_t r = 0; r < ofRegions.size(); ++r)
    body.regions[r].law = body.laws.numberOf(ofRegions[r]);
}

std::vector<PlacedMaterial> materialsOf(const BodyModel& body, const BodySettings& settings)
{
  if (body.isRigid)
    return {};
  if (body.regions.empty())
    return {{settings.materialOf({}), body.laws(0)}};
  std::vector<PlacedMaterial> materials;
  for (const BodyRegion& region : body.regions)
    materials.push_back({settings.materialOf(region.name), body.laws.all()[std::size_t(region.law)]});
  return materials;
}

} // namespace ndframe
