#include "gmsh_solids.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/gmsh_converter.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{
namespace
{

std::string nameOf(const MeshScript& body)
{
  return body.regions.empty() ? "the whole script" : "\"" + body.regions.front() + "\"";
}

} // namespace

GmshSolids::GmshSolids(std::vector<MeshScript> bodies) : bodies_(std::move(bodies)), model_(bodies_.front().file)
{
  if (model_.dimension() != 3)
    throw FileError("the script makes a plane mesh now, and it made solids before.");
  std::vector<int> shown;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const int volume : model_.entitiesOf(3, bodies_[b].regions)) {
      shown.push_back(volume);
      assign(3, volume, b);
    }
  model_.showOnly(3, shown);
  model_.useSettingsForSolids();
}

void GmshSolids::assign(int dim, int tag, std::size_t body)
{
  std::vector<std::size_t>& owners = owners_[{dim, tag}];
  if (!owners.empty() && owners.back() == body)
    return;
  owners.push_back(body);
  if (dim > 0)
    for (const int part : model_.boundaryOf(dim, tag))
      assign(dim - 1, part, body);
}

void GmshSolids::requireCommonFace(std::size_t first, std::size_t second) const
{
  const auto has = [](const std::vector<std::size_t>& owners, std::size_t body) {
    return std::find(owners.begin(), owners.end(), body) != owners.end();
  };
  for (const auto& [entity, owners] : owners_)
    if (entity.first == 2 && has(owners, first) && has(owners, second))
      return;
  throw FileError(fmt::format("{} and {} touch, and share no face in the script, so that gmsh would mesh them "
                              "differently there; let the script say BooleanFragments or Coherence.",
                              nameOf(bodies_[first]), nameOf(bodies_[second])));
}

/// In a volume gmsh asks for it; elsewhere for what bounds volumes of one or several bodies.
double GmshSolids::lengthAt(int dim, int tag, double x, double y, double z, void* solids)
{
  const auto& self = *static_cast<const GmshSolids*>(solids);
  double length = std::numeric_limits<double>::infinity();
  const auto owners = self.owners_.find({dim, tag});
  if (owners == self.owners_.end())
    for (const LengthField* field : self.lengths_)
      length = std::min(length, field->at({x, y, z}));
  else
    for (const std::size_t body : owners->second)
      length = std::min(length, self.lengths_[body]->at({x, y, z}));
  return length;
}

std::vector<Mesh> GmshSolids::mesh(const std::vector<const LengthField*>& lengths, GmshAlgorithm algorithm,
                                   const std::string& file)
{
  NDFRAME_ASSERT(lengths.size() == bodies_.size(), "lengths for every body");
  lengths_ = lengths;
  model_.setSizes(lengthAt, this, int(algorithm));
  model_.session().generate(3);
  model_.session().write(file);
  const MshFile msh = parseMsh(readText(file));
  std::vector<Mesh> meshes;
  for (const MeshScript& body : bodies_)
    meshes.push_back(meshFromMsh(msh, body.regions));
  return meshes;
}

} // namespace ndframe
