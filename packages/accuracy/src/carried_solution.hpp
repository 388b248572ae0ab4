#pragma once

#include <vector>

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// The displacements of a run with the cells that they are given in: where iterations on the next meshes begin.
class CarriedSolution
{
public:
  CarriedSolution() = default; ///< of nothing
  /// Of a run's elastic bodies; of nothing where it has no solution.
  explicit CarriedSolution(const Run& run);
  /// The same with values(). Throws InputError where they are not of such a model.
  CarriedSolution(const Model& model, std::vector<Vector> values);
  std::vector<Vector> values() const; ///< per elastic body and node, global axes

  /// Their values at the nodes of another run's bodies, per body of its interfaces, in the nodes' own axes, without
  /// what supports prescribe. ancestors: per elastic body and cell of its uncut mesh that of the earlier one in whose
  /// place it stands (RefinedMeshes). Empty where nothing is carried, or a body is not solved whole.
  std::vector<NodalField> onto(const Run& run, const std::vector<std::vector<int>>& ancestors) const;

private:
  struct Body
  {
    NodeMap nodes;
    std::vector<std::vector<int>> parts; ///< per uncut cell those of `nodes`; empty: itself
    Vector values;                       ///< dim a node, global axes

    Vector at(const BodyModel& body, const std::vector<int>& ancestors) const;
  };

  std::vector<Body> bodies_; ///< those with stress
};

} // namespace ndframe
