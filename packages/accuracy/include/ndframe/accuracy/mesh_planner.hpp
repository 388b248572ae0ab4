#pragma once

#include <memory>
#include <optional>

#include "ndframe/accuracy/accuracy_components.hpp"
#include "ndframe/accuracy/bound_fall.hpp"
#include "ndframe/accuracy/level_lesson.hpp"
#include "ndframe/adaptivity/corner_exponents.hpp"
#include "ndframe/adaptivity/edge_exponents.hpp"
#include "ndframe/adaptivity/marking.hpp"
#include "ndframe/adaptivity/refinement.hpp"

namespace ndframe
{

/// The next meshes of a run with a target, and what they shall come to.
struct MeshPlan
{
  std::unique_ptr<RefinedMeshes> meshes; ///< of all elastic bodies, before sides are cut to match
  std::int64_t dofs = 0;                 ///< of these meshes, supports included
  double bound = 0.0;                    ///< that is expected
  double predicted = 0.0;                ///< by the contributions alone
};

/// Decides about the next meshes of a run with a target.
class MeshPlanner
{
public:
  /// settings: with a target. model: of the first meshes.
  MeshPlanner(const RunSettings& settings, const AccuracyComponents& components, const Model& model, const Comm& comm);

  /// Takes in what the certificate of the present meshes teaches. uncut: they, per elastic body, with the ends of sides
  /// in the plane, which may split some of their cells.
  void learn(const std::vector<const Mesh*>& uncut, const LevelLesson& lesson);

  /// Dofs of a mesh with the target's bound, without what conformity adds; none where the marking does not predict.
  std::optional<std::int64_t> dofsToTarget() const;

  /// One step on the way to the target, with not more dofs than allowed; more only where every mesh that is worth its
  /// work has more.
  MeshPlan nextStep(std::int64_t maximumDofs) const;

  void accept(MeshPlan plan); ///< its meshes are the present ones from now on
  const std::vector<Mesh>& meshes() const { return present_->meshes(); } ///< the present ones, as in MeshPlan
  /// RefinedMeshes::ancestors of the present meshes.
  const std::vector<std::vector<int>>& ancestors() const { return present_->ancestors(); }
  /// RefinedMeshes::note of the present meshes.
  std::string note() const { return present_->note(); }

private:
  struct FineCell
  {
    std::size_t body, cell;
    FineSegment segment;
  };

  void learnExponents(const std::vector<const Mesh*>& meshes, const std::vector<Vector>& eta, bool isCoarse);
  /// lambda per body and vertex: what has been learned, and where contact ends now.
  std::vector<Vector> exponentsFor(const LevelLesson& lesson) const;
  MeshPlan planFor(double wanted) const;
  /// Of the present meshes: cells with a facet where contact ends that is so long that its nodes bracket the end by
  /// more than `width` times the interface's length.
  std::vector<FineCell> cellsOfBrackets(double width) const;
  bool makesSolidsAnew() const { return dim_ == 3 && !present_->areNested(); }
  double boundPerTotal() const { return correction_ * bound_ / total_; }
  std::int64_t dofsOf(const std::vector<Mesh>& meshes) const;

  int degree_, dim_;
  BoundFall fall_;
  std::unique_ptr<Marking> marking_;
  std::unique_ptr<RefinedMeshes> present_;
  std::vector<std::int64_t>
      eulers_;              ///< per body: vertices - edges + cells, which refinement does not change; in the plane
  CornerExponents corners_; ///< in the plane
  EdgeExponents edges_;     ///< in space
  std::optional<ContributionModel> contributions_;
  std::vector<EndOnSide> brackets_;                 ///< of the present meshes, where contact ends
  bool tells_ = false;                              ///< LevelErrors::tells of the present meshes
  double relative_ = 0.0;                           ///< LevelErrors::relative of the present meshes
  double bound_ = 0.0, target_ = 0.0, total_ = 0.0; ///< of the present meshes; total: sqrt(sum eta_K^2)
  double expected_ = 0.0;                           ///< bound of the present meshes, as it was planned; 0 for the first
  double predicted_ = 0.0;                          ///< MeshPlan::predicted of the present meshes
  double correction_ = 1.0;                         ///< of what is expected
};

} // namespace ndframe
