#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/adaptivity/size_field.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/registry.hpp"
#include "ndframe/mesh/facet_twin.hpp"
#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe
{

/// Meshes of a scene that match along its interfaces, and how they came about. A value: refining makes new ones.
class RefinedMeshes
{
public:
  virtual ~RefinedMeshes() = default;

  virtual const std::vector<Mesh>& meshes() const = 0; ///< in the order of FirstMeshes

  /// Per mesh and cell of meshes(): the cell of the meshes before in whose place it stands (of which it is a part, but
  /// where shapes were mended), or in which its centre lies.
  virtual const std::vector<std::vector<int>>& ancestors() const = 0;
  /// Points of earlier meshes stay, and edges are halved in the middle.
  virtual bool areNested() const = 0;
  /// They are the meshes before, cell by cell.
  bool areUnchanged() const;

  /// The next meshes: cells as the field wants them, or smaller where matching sides or shapes need it.
  virtual std::unique_ptr<RefinedMeshes> refined(const SizeField& sizes) const = 0;

  /// What a user should know of how these meshes came about; mostly nothing.
  virtual std::string note() const { return {}; }

  /// Part by which an error may stay below what is wanted before it pays to aim again.
  virtual double slack() const = 0;
};

/// What a refinement begins with, body by body.
struct FirstMeshes
{
  std::vector<Mesh> meshes;                               ///< sound, of the same dimension
  std::vector<FacetTwin> twins;                           ///< where they match
  std::vector<std::shared_ptr<const MeshSource>> sources; ///< of the deck, per mesh; Remesh needs them
};

/// How meshes are refined.
class Refinement
{
public:
  virtual ~Refinement() = default;

  /// The first meshes; their ancestors are the cells themselves. Throws InputError where this refinement is not
  /// possible. comm: outlives what is returned.
  virtual std::unique_ptr<RefinedMeshes> begin(FirstMeshes first, const Comm& comm) const = 0;
};

/// "Bisection" (default), "Remesh".
void registerRefinements(Registry<Refinement>& registry);

} // namespace ndframe
