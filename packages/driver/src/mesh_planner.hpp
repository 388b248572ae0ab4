#pragma once

#include <optional>

#include "level_errors.hpp"
#include "ndframe/estimation/graded_refinement.hpp"

namespace ndframe
{

/// What the next meshes shall come to.
struct MeshPlan
{
  Prediction prediction;
  std::int64_t dofs = 0;
  double bound = 0.0; ///< that is expected
};

/// Decides about the next meshes of a run with a target, and makes them.
class MeshPlanner
{
public:
  /// The first meshes.
  explicit MeshPlanner(const Model& model);

  /// Takes in the certificate of the present meshes.
  void learn(const Run& run, const LevelErrors& errors);

  /// Meshes with the bound `wanted`, predicted from the present ones.
  MeshPlan planFor(double wanted) const;
  /// One step on the way to the target, and not more dofs than allowed. Without a finer mesh that may be made: a plan
  /// with the dofs of the present one.
  MeshPlan nextStep(std::int64_t maximumDofs) const;

  void refine(const MeshPlan& plan);
  const std::vector<Mesh>& meshes() const { return bisection_.meshes(); }

private:
  int degree_;
  Bisection bisection_;
  CornerExponents exponents_;
  std::optional<GradedRefinement> refinement_;
  double bound_ = 0.0, target_ = 0.0, total_ = 0.0; ///< of the present meshes; total: sqrt(sum eta_K^2)
  double expected_ = 0.0;                           ///< bound of the present meshes, as it was planned; 0 for the first
  double optimism_ = 1.0;                           ///< of the last plan, which the next one makes up for
  double dofsPerCell_ = 0.0;
  std::int64_t numDofs_ = 0;
};

} // namespace ndframe
