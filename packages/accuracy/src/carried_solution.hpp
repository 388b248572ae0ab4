#pragma once

#include <memory>
#include <vector>

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// The displacements of a run with the cells that they are given in: where iterations on the next meshes begin. Of
/// bodies that are shared out every rank has its part.
class CarriedSolution
{
public:
  CarriedSolution() = default; ///< of nothing
  /// Of a run's elastic bodies; of nothing where it has no solution.
  explicit CarriedSolution(const Run& run);
  /// The same with values(), on every rank. Throws InputError where they are not of such a model.
  CarriedSolution(const Model& model, const std::vector<Vector>& values);
  /// Per elastic body and node of the whole body, in the order of the numbers of shares, global axes; where bodies are
  /// shared out, on rank 0 only. Collective.
  std::vector<Vector> values(const Comm& comm) const;

  /// Their values at the nodes of another run's bodies, per body of its interfaces, in the nodes' own axes, without
  /// what supports prescribe. ancestors: per elastic body and cell of its uncut mesh that of the earlier one in whose
  /// place it stands (RefinedMeshes). Empty where nothing is carried, or a body is not solved whole. The bodies of
  /// either run may be shared out, and not alike. Collective.
  std::vector<NodalField> onto(const Run& run, const std::vector<std::vector<int>>& ancestors, const Comm& comm) const;

private:
  struct Body
  {
    NodeMap nodes;
    std::vector<std::vector<int>> parts; ///< per uncut cell those of `nodes`; empty: itself
    Vector values;                       ///< dim a node, global axes
    std::shared_ptr<const BodyShare> share;

    Vector at(const BodyModel& body, const std::vector<int>& ancestors, const Comm& comm) const;
    /// At points in or near cells of the whole uncut mesh, dim each, wherever they are. Collective.
    Vector at(const std::vector<BodyShare::Global>& cells, const Vector& points, const Comm& comm) const;
    /// The same in uncut cells that this rank has, as it numbers them.
    Vector at(const std::vector<int>& cells, const Vector& points) const;
  };

  void add(const BodyModel& body, Vector values);

  std::vector<Body> bodies_; ///< those with stress
};

} // namespace ndframe
