#include <fmt/format.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/base/list_place.hpp"
#include "ndframe/mesh/cell_locator.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"
#include "ndframe/meshing/remesh.hpp"
#include "persistent_remesh.hpp"
#include "refinements.hpp"
#include "remesh_sizes.hpp"

namespace ndframe
{
namespace
{

/// What all meshes of a run have in common.
struct RemeshScene
{
  std::vector<MeshScript> scripts;
  std::vector<MatchingSides> matching;
  const Comm& comm;
};

/// Meshed on rank 0, which tells the others; one mesh a message. None where gmsh gives up.
std::vector<Mesh> remeshShared(const RemeshScene& scene, const std::vector<WantedMesh>& wanted)
{
  std::vector<Mesh> meshes;
  const auto make = [&](const std::vector<WantedMesh>& lengths, GmshAlgorithm algorithm) {
    return remesh(scene.scripts, scene.matching, lengths, algorithm);
  };
  constexpr const char* made = "made";
  const std::string outcome = fromRankZero(scene.comm, [&]() -> std::string {
    try {
      meshes = remeshPersistently(wanted, make);
      return made;
    } catch (const RemeshFailure&) {
      return "gmsh gives up";
    }
  });
  if (outcome != made || scene.comm.size() == 1)
    return meshes;
  meshes.resize(wanted.size());
  for (Mesh& mesh : meshes)
    mesh = meshFromBytes(fromRankZero(scene.comm, [&] { return toBytes(mesh); }));
  return meshes;
}

std::vector<int> ancestorsIn(const Mesh& before, const Mesh& mesh)
{
  const CellLocator cells(before);
  std::vector<int> ancestors;
  for (int c = 0; c < mesh.numCells(); ++c)
    ancestors.push_back(cells.find(cellCentre(mesh, c)).cell);
  return ancestors;
}

/// Bisection makes the sizes; gmsh makes meshes with them.
class RemeshedMeshes final : public RefinedMeshes
{
public:
  RemeshedMeshes(std::shared_ptr<const RemeshScene> scene, std::vector<Mesh> meshes,
                 std::vector<std::vector<int>> ancestors, std::string note = {})
      : scene_(std::move(scene)), meshes_(std::move(meshes)), ancestors_(std::move(ancestors)), note_(std::move(note))
  {}

  const std::vector<Mesh>& meshes() const override { return meshes_; }
  const std::vector<std::vector<int>>& ancestors() const override { return ancestors_; }

  std::unique_ptr<RefinedMeshes> refined(const SizeField& sizes) const override
  {
    const bool isSolid = meshes_.front().dim == 3;
    const auto parts = bisectedMeshes(meshes_, isSolid ? twins() : std::vector<FacetTwin>())->refined(sizes);
    std::vector<WantedMesh> wanted;
    for (std::size_t b = 0; b < meshes_.size(); ++b) {
      const Mesh& mesh = parts->meshes()[b];
      wanted.push_back({mesh, lengthsOn(mesh, parts->ancestors()[b], meshes_[b], sizes[b])});
    }
    std::vector<Mesh> next = remeshShared(*scene_, wanted);
    if (next.empty())
      return bisected(sizes);
    std::vector<std::vector<int>> ancestors;
    for (std::size_t b = 0; b < next.size(); ++b)
      ancestors.push_back(ancestorsIn(meshes_[b], next[b]));
    return std::make_unique<RemeshedMeshes>(scene_, std::move(next), std::move(ancestors));
  }

  bool areNested() const override { return false; }
  std::string note() const override { return note_; }

  /// Loading gmsh takes longer than solving on a few cells more; in space cells cost more.
  double slack() const override { return meshes_.front().dim == 2 ? 0.2 : 0.05; }

private:
  /// What is left where gmsh gives up: the vertices stay, curved boundaries are followed again by the next mesh that it
  /// makes.
  std::unique_ptr<RefinedMeshes> bisected(const SizeField& sizes) const
  {
    const auto next = bisectedMeshes(meshes_, twins())->refined(sizes);
    return std::make_unique<RemeshedMeshes>(scene_, next->meshes(), next->ancestors(),
                                            "gmsh failed with these sizes; the previous cells were bisected");
  }

  std::vector<FacetTwin> twins() const
  {
    return meshes_.front().dim == 3 ? commonFacets(meshes_) : twinsOf(meshes_, scene_->matching);
  }

  std::shared_ptr<const RemeshScene> scene_;
  std::vector<Mesh> meshes_;
  std::vector<std::vector<int>> ancestors_;
  std::string note_;
};

class RemeshRefinement final : public Refinement
{
public:
  explicit RemeshRefinement(const Params& list) : place_(list) {}

  std::unique_ptr<RefinedMeshes> begin(FirstMeshes first, const Comm& comm) const override
  {
    auto scene = std::make_shared<RemeshScene>(RemeshScene{{}, matchingSides(first.meshes, first.twins), comm});
    for (const auto& source : first.sources)
      scene->scripts.push_back(source->script());
    if (first.meshes.front().dim == 3)
      refuseTwoScripts(*scene, first.twins);
    std::vector<std::vector<int>> ancestors = ownAncestors(first.meshes);
    return std::make_unique<RemeshedMeshes>(std::move(scene), std::move(first.meshes), std::move(ancestors));
  }

private:
  void refuseTwoScripts(const RemeshScene& scene, const std::vector<FacetTwin>& twins) const
  {
    for (const FacetTwin& twin : twins) {
      const std::string &one = scene.scripts[std::size_t(twin.first)].file,
                        &other = scene.scripts[std::size_t(twin.second)].file;
      if (one != other)
        throw InputError(place_.mistake(
            "Type", fmt::format("sides of {} and {} have the same triangles, and gmsh would not mesh two scripts "
                                "alike; draw both bodies in one script with a common face, or refine by Bisection.",
                                one, other)));
    }
  }

  ListPlace place_;
};

} // namespace

void registerRemesh(Registry<Refinement>& registry)
{
  registry.add("Remesh",
               "gmsh remeshes .geo scripts with the required sizes. Vertices of a curved boundary lie on the curve or "
               "surface, matching sides still match; solids that match are of one script and share a face there. "
               "Costs 0.1 s per mesh and more. Where gmsh fails, it is tried again with other algorithms and slightly "
               "smaller sizes; in the end the cells are bisected.",
               {}, [](const Params& list) { return std::make_unique<RemeshRefinement>(list); });
}

} // namespace ndframe
