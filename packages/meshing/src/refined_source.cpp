#include "ndframe/meshing/refined_source.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ndframe/base/grouped.hpp"
#include "ndframe/base/memory.hpp"
#include "ndframe/mesh/refine.hpp"

namespace ndframe
{
namespace
{

constexpr const char* key = "Refine";
constexpr int most = 8;

double cellsAfter(const Mesh& mesh, int halvings)
{
  return double(mesh.numCells()) * std::pow(numChildren(mesh.dim), halvings);
}

/// Points and facets are numbered by int.
bool canBeNumbered(const Mesh& mesh, int halvings)
{
  return cellsAfter(mesh, halvings) * (mesh.dim + 1) <= std::numeric_limits<int>::max();
}

/// Of the mesh and the ordering of its facets.
double bytesAfter(const Mesh& mesh, int halvings)
{
  return cellsAfter(mesh, halvings) * (mesh.dim + 1) * (mesh.dim + 3) * sizeof(int);
}

/// The mesh of another source with its edges halved.
class RefinedSource final : public MeshSource
{
public:
  RefinedSource(std::unique_ptr<MeshSource> source, const Params& list)
      : source_(std::move(source)), list_(list), halvings_(halvingsOf(list))
  {}

  Mesh read() const override { return refined(source_->read()); }
  Mesh readWith(ScriptMeshes& scripts) const override { return refined(source_->readWith(scripts)); }
  const MeshSource& drawn() const override { return *source_; }
  MeshScript script() const override { return source_->script(); }
  Mesh refined(Mesh mesh) const override
  {
    checkSize(mesh);
    const int before = mesh.numCells();
    for (int k = 0; k < halvings_; ++k)
      mesh = refineUniformly(mesh);
    mesh.notes.push_back(
        fmt::format("Refine = {}: {} cells became {}.", halvings_, grouped(before), grouped(mesh.numCells())));
    const auto mistakes = checkMesh(mesh);
    if (!mistakes.empty())
      throw InputError(
          list_.mistake(key, fmt::format("the refined mesh cannot be used: {} Use a smaller number.", mistakes[0])));
    return mesh;
  }

private:
  void checkSize(const Mesh& mesh) const
  {
    const MemoryLeft left = memoryLeft();
    int largest = halvings_;
    const auto isPossible = [&](int k) { return canBeNumbered(mesh, k) && bytesAfter(mesh, k) <= double(left.bytes); };
    while (largest > 0 && !isPossible(largest))
      --largest;
    if (largest == halvings_)
      return;
    const std::string why = canBeNumbered(mesh, halvings_)
                                ? fmt::format("which need {:.3g} GB for the mesh alone, and {} are available",
                                              1e-9 * bytesAfter(mesh, halvings_), left.text())
                                : "more than can be numbered";
    throw InputError(
        list_.mistake(key, fmt::format("Refine = {} makes {:.3g} cells of {}, {}; use at most {}.", halvings_,
                                       cellsAfter(mesh, halvings_), grouped(mesh.numCells()), why, largest)));
  }

  std::unique_ptr<MeshSource> source_;
  Params list_;
  int halvings_;
};

} // namespace

int halvingsOf(const Params& mesh)
{
  return mesh.get<int>(key);
}

void addMeshSource(Registry<MeshSource>& registry, std::string name, std::string doc, std::vector<ParamSpec> params,
                   Registry<MeshSource>::Builder builder, std::vector<ListSpec> lists)
{
  params.push_back(
      {key, 0, inClosedRange(0, most),
       "How many times, k, every edge is halved when the mesh is read: a triangle becomes 4^k triangles, a tetrahedron "
       "8^k. Sides and groups are kept, and matching sides still match with the same number on both. A curve stays the "
       "polygon of the mesh, with its corners: mesh it finely from the start. Directions of contact are those of the "
       "mesh that is not halved: the scene is the same with every Refine (but for tied bodies, which are halved before "
       "they are glued). Several "
       "processes that solve solids whole (Multigrid, Monolithic) share the mesh out before they refine it, so that "
       "none has the refined mesh, where nothing asks for all of a body: no estimator Reference, no recovery Star. "
       "Meshes that are not refined, and those of a target's levels, which all processes have, are shared out likewise "
       "from 200 vertices a process on, where Multigrid is named, or from 300 000 dofs on, where Automatic chooses "
       "it."});
  registry.add(
      std::move(name), std::move(doc), std::move(params),
      [build = std::move(builder)](const Params& list) -> std::unique_ptr<MeshSource> {
        auto source = build(list);
        return halvingsOf(list) == 0 ? std::move(source) : std::make_unique<RefinedSource>(std::move(source), list);
      },
      std::move(lists));
}

} // namespace ndframe
