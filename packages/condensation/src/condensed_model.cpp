#include "ndframe/condensation/condensed_model.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "body_progress.hpp"
#include "mortar_conditions.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/scene/stage.hpp"
#include "node_owners.hpp"
#include "share_problem.hpp"
#include "trace_nodes.hpp"

namespace ndframe
{
namespace
{

DofLayout layOut(const Model& model, std::size_t b, const BodyTraceNodes& nodes)
{
  return makeDofLayout(model.bodies[b].nodes, model.constraints[b], nodes.traces);
}

BodySystem assemble(const Model& model, std::size_t b, DofLayout layout, const NodeOwners& owners, const Comm& comm)
{
  const auto& share = model.bodies[b].share;
  return assembleBody(model.bodies[b], std::move(layout),
                      share ? share->ownNodes() : owners.ownedBy(comm.rank(), int(b)), model.loads[b]);
}

/// A body whose dofs are all prescribed needs no factor.
class HeldBody final : public CondensedBody
{
public:
  explicit HeldBody(int dofs) : dofs_(dofs) {}
  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix&) const override { return {dofs_, load.cols()}; }
  DenseMatrix reduce(const DenseMatrix& load) const override { return {0, load.cols()}; }
  Vector applySchur(const Vector&) const override { return {}; }
  DenseMatrix schurComplement() const override { return {0, 0}; }
  bool hasCheapSchur() const override { return true; }
  std::string description() const override { return "nothing to factor"; }

private:
  int dofs_;
};

std::unique_ptr<CondensedBody> factorBody(const Model& model, int number, const BodySystem& system,
                                          const LinearSolver& solver, const Comm& comm, Ledger& ledger)
{
  const BodyModel& body = model.bodies[std::size_t(number)];
  if (body.isRigid)
    return std::make_unique<HeldBody>(body.numDofs());
  if (system.share) {
    auto shared = solver.share(shareProblem(model, number, system), comm, ledger);
    NDFRAME_ASSERT(shared, "only solvers that take shares get them");
    return shared;
  }
  try {
    return solver.factor(solverProblem(model, number, system), comm, ledger);
  } catch (const SingularBody& failure) {
    const int node = failure.dof < 0 ? -1 : failure.dof / body.mesh.dim;
    throw InputError(fmt::format(
        "Bodies/{}: its matrix is singular{}: is a part of the mesh not connected to the rest, or an "
        "element nearly flat? ({})",
        body.name, node < 0 ? std::string() : " at " + pointText(body.nodes.point(node).data(), body.mesh.dim),
        failure.what()));
  }
}

/// What each column makes of the rows.
DenseMatrix multiplied(const AffineRows& map, const DenseMatrix& columns)
{
  DenseMatrix result(int(map.rows.size()), columns.cols());
  for (int j = 0; j < columns.cols(); ++j)
    for (std::size_t i = 0; i < map.rows.size(); ++i)
      for (const auto& [k, share] : map.rows[i])
        result(int(i), j) += share * columns(k, j);
  return result;
}

BodyTrace makeTrace(const Model& model, int body, const BodyTraceNodes& all, const DofLayout& layout)
{
  BodyTraceMap maps = mapOf(all, layout);
  BodyTrace trace;
  trace.body = body;
  trace.map = std::move(maps.map);
  trace.dependents = std::move(maps.dependents);
  const BodyTraceNodes nodes = all.without(layout.dependents);
  trace.unknowns = nodes.unknowns;
  trace.roles = nodes.roles;
  std::vector<Direction> normals;
  for (const auto& t : nodes.traces)
    normals.push_back(t.normal);
  const auto& rigid = model.rigid[std::size_t(body)];
  const auto& free = model.freeMotions[std::size_t(body)];
  trace.freeMotions = multiplied(maps.coefficients, motionTraces(rigid, free, nodes.points, normals));
  if (free.cols() > 0)
    for (const auto& motion : describeMotions(rigid, free))
      trace.motionNames.push_back(fmt::format("{} of {}", motion, model.bodies[std::size_t(body)].name));
  return trace;
}

/// Condenses a model body by body and keeps of an earlier condensed scene what the model has not changed.
class Condenser
{
public:
  Condenser(const Model& model, const LinearSolver& solver, const InterfaceOperator& representation, const Comm& comm,
            Ledger& ledger, CondensedModel previous, const FactorObserver& onFactor)
      : model_(model), solver_(solver), representation_(representation), comm_(comm), ledger_(ledger),
        onFactor_(onFactor), result_(std::move(previous))
  {
    if (result_.recipe.bodies.size() != model.recipe.bodies.size())
      result_ = {};
    recipe_ = std::exchange(result_.recipe, model.recipe);
    interface_ = std::exchange(result_.interface, {});
    result_.systems.reserve(model.bodies.size()); // the factors point to the matrices
    result_.condensed.resize(model.bodies.size());
    result_.loads.resize(model.bodies.size());
    result_.ranks.resize(model.bodies.size());
    result_.threads = solver.allowsThreads(comm.size()) ? numThreads(comm) : 1;
    traces_.resize(model.bodies.size());
  }

  CondensedModel run() &&
  {
    const auto traceNodes = numberUnknowns(model_, result_.interface);
    if (!model_.interfaces.empty())
      result_.interface.C = std::make_shared<ContactMatrix>(model_.interfaces);
    result_.interface.mortar = mortarSpace(model_, result_.interface);
    for (std::size_t b = 0; b < model_.bodies.size(); ++b)
      layOutBody(b, traceNodes[b]);
    if (std::any_of(kept_.begin(), kept_.end(), [](const Kept& kept) { return !kept.factor; }))
      owners_.emplace(model_, model_.told ? 1 : comm_.size()); // rigid bodies are the first rank's then
    for (std::size_t b = 0; b < model_.bodies.size(); ++b)
      if (!kept_[b].factor && !model_.told)
        result_.ranks[b] = owners_->ofVertices(model_, int(b));
    const std::vector<int> sizes = model_.numDofs();
    const auto largest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    assembleWhatIsNew(largest); // before the others begin: it has to be ordered first, for only one can be at a time
    BodyProgress progress(sizes, model_.bodies.front().mesh.dim, ledger_);
    runLargestFirst(sizes, result_.threads, [&](int body) {
      const auto b = std::size_t(body);
      if (b != largest)
        assembleWhatIsNew(b);
      condenseBody(b);
      progress.isDone(b);
    });
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
      if (kept_[b].factor)
        ledger_.count("factors reused");
      else if (onFactor_ && !model_.bodies[b].isRigid)
        onFactor_(model_.bodies[b].name, result_.condensed[b]->description());
      if (traces_[b].map.size() > 0)
        result_.interface.bodies.push_back(std::move(traces_[b]));
    }
    return std::move(result_);
  }

private:
  /// What of a body's earlier condensation is still right; each needs the one before it.
  struct Kept
  {
    bool factor = false, schur = false, load = false;
  };

  Kept whatIsKept(std::size_t b)
  {
    Kept kept;
    if (recipe_.bodies.empty())
      return kept;
    const BodyRecipe &before = recipe_.bodies[b], &now = model_.recipe.bodies[b];
    kept.factor = before.mesh == now.mesh && before.matrix == now.matrix && recipe_.sameSolver(model_.recipe) &&
                  layouts_[b].splitsLike(result_.systems[b].dofs);
    const auto earlier = earlierTrace(b);
    kept.schur = kept.factor && recipe_.representation == model_.recipe.representation &&
                 earlier != interface_.bodies.end() && traces_[b].map.isLike(earlier->map);
    kept.load = kept.schur && before.load == now.load;
    return kept;
  }

  /// Numbers the body's dofs and lets go of a factor that is of no use any more: the new ones need its memory.
  void layOutBody(std::size_t b, const BodyTraceNodes& nodes)
  {
    layouts_.push_back(layOut(model_, b, nodes));
    if (!nodes.traces.empty())
      traces_[b] = makeTrace(model_, int(b), nodes, layouts_[b]);
    kept_.push_back(whatIsKept(b));
    if (b == result_.systems.size())
      result_.systems.push_back({layouts_[b], {}, {}}); // a place for condenseBody()
    if (!kept_[b].factor)
      result_.condensed[b].reset();
  }

  /// Like condenseBody(), it touches nothing of other bodies.
  void assembleWhatIsNew(std::size_t b)
  {
    if (kept_[b].load)
      return;
    const auto timer = timeStage(ledger_, Stage::Assemble);
    BodySystem& system = result_.systems[b];
    if (!kept_[b].factor) {
      system = assemble(model_, b, std::move(layouts_[b]), *owners_, comm_);
    } else { // other loads or prescribed values, the same matrix
      assembleAgain(system, model_.bodies[b]);
      system.dofs = std::move(layouts_[b]);
      system.load = inOwnAxes(model_.loads[b], system.dofs.frames);
    }
    result_.loads[b] = system.effectiveLoad(comm_);
  }

  void condenseBody(std::size_t b)
  {
    if (!kept_[b].factor)
      result_.condensed[b] = factorBody(model_, int(b), result_.systems[b], solver_, comm_, ledger_);
    if (traces_[b].map.size() > 0)
      condenseTrace(b);
  }

  void condenseTrace(std::size_t b)
  {
    const auto timer = timeStage(ledger_, Stage::Interface);
    const auto earlier = earlierTrace(b);
    BodyTrace& trace = traces_[b];
    trace.S = kept_[b].schur ? earlier->S : traceOperator(*result_.condensed[b], trace.map, representation_);
    trace.load = &result_.loads[b];
    trace.share = model_.bodies[b].share;
    trace.whole = model_.solvesWhole ? wholeSolver(*result_.condensed[b]) : nullptr;
    if (kept_[b].load) {
      trace.g = std::move(earlier->g);
      return;
    }
    trace.g = ReducedLoad([&body = *result_.condensed[b], map = trace.map, S = trace.S, &load = result_.loads[b]] {
      return traceLoad(body, map, *S, load.all());
    });
    if (trace.whole == nullptr)
      trace.g.size(); // finds it now, while other bodies are condensed beside
  }

  std::vector<BodyTrace>::iterator earlierTrace(std::size_t b)
  {
    return std::find_if(interface_.bodies.begin(), interface_.bodies.end(),
                        [&](const BodyTrace& trace) { return trace.body == int(b); });
  }

  const Model& model_;
  const LinearSolver& solver_;
  const InterfaceOperator& representation_;
  const Comm& comm_;
  Ledger& ledger_;
  const FactorObserver& onFactor_;
  CondensedModel result_;
  SceneRecipe recipe_;             ///< of the earlier scene
  InterfaceSystem interface_;      ///< the same
  std::vector<DofLayout> layouts_; ///< per body
  std::vector<Kept> kept_;         ///< per body
  std::optional<NodeOwners> owners_;
  std::vector<BodyTrace> traces_; ///< per body, empty for those that touch nothing
};

} // namespace

const BodyTrace* CondensedModel::trace(int body) const
{
  const auto found = std::find_if(interface.bodies.begin(), interface.bodies.end(),
                                  [body](const BodyTrace& trace) { return trace.body == body; });
  return found == interface.bodies.end() ? nullptr : &*found;
}

std::vector<BodySystem> assembleSystems(const Model& model, const Comm& comm)
{
  InterfaceSystem numbering;
  const auto traceNodes = numberUnknowns(model, numbering);
  const NodeOwners owners(model, comm.size());
  std::vector<BodySystem> systems;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    systems.push_back(assemble(model, b, layOut(model, b, traceNodes[b]), owners, comm));
  return systems;
}

CondensedModel condense(const Model& model, const LinearSolver& solver, const InterfaceOperator& representation,
                        const Comm& comm, Ledger& ledger, CondensedModel previous, const FactorObserver& onFactor)
{
  if (model.recipe.sameSystems(previous.recipe)) {
    ledger.count("factors reused", std::int64_t(model.bodies.size()));
    return previous;
  }
  return Condenser(model, solver, representation, comm, ledger, std::move(previous), onFactor).run();
}

} // namespace ndframe
