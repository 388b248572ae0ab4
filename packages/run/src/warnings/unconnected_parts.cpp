#include <numeric>
#include <set>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{
namespace
{

/// Which part a cell belongs to, by union of cells that share a facet.
class Parts
{
public:
  explicit Parts(int cells) : parent_(std::size_t(cells)) { std::iota(parent_.begin(), parent_.end(), 0); }

  int of(int cell)
  {
    while (parent_[std::size_t(cell)] != cell)
      cell = parent_[std::size_t(cell)] = parent_[std::size_t(parent_[std::size_t(cell)])];
    return cell;
  }
  void join(int a, int b) { parent_[std::size_t(of(a))] = of(b); }

private:
  std::vector<int> parent_;
};

} // namespace

/// Parts of a mesh that share no facet are bodies of their own: nothing is carried from one to the other.
void findUnconnectedParts(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    if (body.isRigid)
      continue;
    const Mesh& mesh = body.mesh;
    Parts parts(mesh.numCells());
    for (const auto& [cell, neighbour] : neighbourCells(mesh))
      parts.join(cell, neighbour);
    std::set<int> roots;
    int cell = 0; // the first that is not in the part of cell 0
    for (int c = 0; c < mesh.numCells(); ++c)
      if (roots.insert(parts.of(c)).second && roots.size() == 2)
        cell = c;
    if (roots.size() < 2)
      continue;
    found.add(scene.bodies[b].place.mistake(
        "", fmt::format("its mesh has {} parts that share no {}; one of them is at {}. Nothing connects them: merge "
                        "their points, or make them bodies with an interface.",
                        roots.size(), mesh.dim == 2 ? "edge" : "face",
                        pointText(cellCentre(mesh, cell).data(), mesh.dim))));
  }
}

} // namespace ndframe
