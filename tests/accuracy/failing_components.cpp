#include "failing_components.hpp"
#include "ndframe/iterative/linear_solvers.hpp"

#include <algorithm>

namespace ndframe::test
{
namespace
{

PlannedFailure planned;
std::vector<std::int64_t> sizesSeen; ///< of the levels that a component has met

/// A component on a level; a level is known by its size.
void visit(std::int64_t size)
{
  if (std::find(sizesSeen.begin(), sizesSeen.end(), size) == sizesSeen.end())
    sizesSeen.push_back(size);
  if (int(sizesSeen.size()) == planned.level && size == sizesSeen.back())
    planned.fail();
}

/// A component as a deck without parameters gets it.
template <class Component>
std::unique_ptr<Component> byDefault(void (*registerAll)(Registry<Component>&), const std::string& type)
{
  Registry<Component> registry("component", type);
  registerAll(registry);
  return registry.build({"Type=" + type});
}

class FailingSolver final : public LinearSolver
{
public:
  std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    if (problem.roles[1] != DofRole::Fixed) // of the bodies of the punch the one that is not clamped
      visit(std::int64_t(problem.roles.size()));
    return solver_->factor(std::move(problem), comm, ledger);
  }
  std::string name(int ranks) const override { return solver_->name(ranks); }
  bool needsMpi(int ranks) const override { return solver_->needsMpi(ranks); }

private:
  std::unique_ptr<LinearSolver> solver_ = byDefault(registerLinearSolvers, "Automatic");
};

class FailingRecovery final : public StressRecovery
{
public:
  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override
  {
    std::int64_t cells = 0;
    for (const BodyModel* body : scene.bodies)
      cells += body->mesh.numCells();
    visit(cells);
    return recovery_->recover(scene, fields, comm, ledger);
  }
  int degree(int order) const override { return recovery_->degree(order); }
  bool optimises(int dim) const override { return recovery_->optimises(dim); }
  std::string refusal(int dim, int order, bool optimise) const override
  {
    return recovery_->refusal(dim, order, optimise);
  }

private:
  std::unique_ptr<StressRecovery> recovery_ = byDefault(registerRecoveries, "Star");
};

/// Fails where the meshes of the planned level are to be made.
class FailingMeshes final : public RefinedMeshes
{
public:
  FailingMeshes(std::unique_ptr<RefinedMeshes> meshes, int level) : meshes_(std::move(meshes)), level_(level) {}
  const std::vector<Mesh>& meshes() const override { return meshes_->meshes(); }
  const std::vector<std::vector<int>>& ancestors() const override { return meshes_->ancestors(); }
  bool areNested() const override { return meshes_->areNested(); }
  double slack() const override { return meshes_->slack(); }
  std::unique_ptr<RefinedMeshes> refined(const SizeField& sizes) const override
  {
    if (level_ + 1 == planned.level)
      planned.fail();
    return std::make_unique<FailingMeshes>(meshes_->refined(sizes), level_ + 1);
  }

private:
  std::unique_ptr<RefinedMeshes> meshes_;
  int level_;
};

class FailingRefinement final : public Refinement
{
public:
  std::unique_ptr<RefinedMeshes> begin(FirstMeshes first, const Comm& comm) const override
  {
    return std::make_unique<FailingMeshes>(byDefault(registerRefinements, "Bisection")->begin(std::move(first), comm),
                                           1);
  }
};

} // namespace

const Components& failingComponents(const PlannedFailure& plan)
{
  static const auto all = makeComponents([](Components& components) {
    const auto doc = "Fails on one level.";
    components.linearSolvers.add("Failing", doc, {}, [](const Params&) { return std::make_unique<FailingSolver>(); });
    components.recoveries.add("Failing", doc, {}, [](const Params&) { return std::make_unique<FailingRecovery>(); });
    components.refinements.add("Failing", doc, {}, [](const Params&) { return std::make_unique<FailingRefinement>(); });
  });
  planned = plan;
  sizesSeen.clear();
  return *all;
}

} // namespace ndframe::test
