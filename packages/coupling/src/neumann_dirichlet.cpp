#include <optional>
#include <utility>

#include "dirichlet_problem.hpp"
#include "initial_traction.hpp"
#include "iteration_error.hpp"
#include "ndframe/algebra/dense.hpp"
#include "stopping.hpp"

namespace ndframe
{
namespace
{

constexpr double roundOff = 1e-15;

/// The Neumann-Dirichlet algorithm of section 4.2.3: Neumann problem on body 2 (25), unilateral problem on body 1 (26),
/// relaxed update of the traction (27), until eps_tau is small. Bayada, Sabil and Sassi (2002) prove convergence for
/// small theta.
///
/// A floating Neumann body gets tractions that balance its loads - the first one is made so, and then every one is, as
/// a mean of two - and is placed by the unilateral problem.
///
/// Where the iteration's part of the error has a goal, each sweep measures it (iteration_error.hpp).
///
/// Limits: a body is Dirichlet or Neumann body on all its interfaces, and Dirichlet body if it meets obstacles. The
/// factor of convergence is 1 - theta (1 + mu), mu the ratio of the Dirichlet to the Neumann body's stiffness
/// (role_spectrum.hpp).
class NeumannDirichlet final : public Coupling
{
public:
  NeumannDirichlet(Roles roles, std::shared_ptr<RelaxationController> relaxation, InitialTraction initial,
                   Stopping stopping)
      : roles_(roles), relaxation_(std::move(relaxation)), initial_(initial), stopping_(stopping)
  {}

  Roles roles() const override { return roles_; }
  bool needsSpectrum() const override { return relaxation_->needsSpectrum(); }
  std::optional<double> givenTheta() const override { return relaxation_->givenTheta(); }
  bool keepsSweeps() const override { return true; }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                       const CouplingStart& start) const override
  {
    const RoleSystem body1 = gatherRole(system, ContactRole::Dirichlet),
                     body2 = gatherRole(system, ContactRole::Neumann);
    const NeumannProblem neumann(*body2.S, body2.g, body2.freeMotions, ledger, system.isObstacle);
    DirichletProblem dirichlet(body1, body2, ledger);
    std::optional<IterationError> iteration;
    if (start.iterationError)
      iteration.emplace(system, body1, body2, neumann, ledger);
    const Stopping stopping = stopping_.withGoal(start.iterationError.value_or(0.0));
    CouplingResult result;
    result.state.closed = firstStatuses(system, body1.freeMotions.cols() + body2.freeMotions.cols() > 0, start);
    InterfaceValues traction = firstTraction(system, body1, body2, start);
    startRelaxation(system, ledger, start);
    if (start.sweeps.after) {
      traction = goOn(*start.sweeps.after, system, result, ledger);
      forget(dirichlet, body2);
    }
    for (;;) {
      try {
        sweep(system, neumann, dirichlet, iteration, traction, result);
      } catch (const NotConverged& failure) {
        if (result.history.empty())
          throw;
        result.reason = failure.what();
        return result;
      }
      announce(result, stopping, observe, ledger);
      if (stopping.ends(result, agree(result.state, norm(body1.g) + norm(body2.g))))
        return result;
      if (start.sweeps.every > 0 && int(result.history.size()) % start.sweeps.every == 0) {
        start.sweeps.keep({result.history, result.state, traction, relaxation_->memory(), ledger.counts(), {}});
        forget(dirichlet, body2);
      }
    }
  }

private:
  /// What was kept knows nothing of the solutions before it, so that those after it must not.
  static void forget(DirichletProblem& dirichlet, const RoleSystem& neumann)
  {
    dirichlet.forgetSolutions();
    neumann.S->forgetSolutions();
  }

  /// One sweep from a traction, which becomes that of the next one. Where it throws, nothing has changed.
  void sweep(const InterfaceSystem& system, const NeumannProblem& neumann, DirichletProblem& dirichlet,
             const std::optional<IterationError>& iteration, InterfaceValues& traction, CouplingResult& result) const
  {
    const UnknownValues force = system.force(traction);
    UnknownValues u2 = system.withObstacles(ofUnknowns(neumann.solve(force)));       // (25)
    const DirichletStep step = dirichlet.solve(u2, system.gap, result.state.closed); // (26)
    const Vector lastJump = jumpOf(result.state);
    result.state = displacements(step, std::move(u2));
    result.state.forceNeumann = force;
    result.state.tractionDirichlet = system.traction(result.state.forceDirichlet);
    auto relaxed = relaxation_->next(result.state.tractionDirichlet, traction); // (27)
    result.state.tractionNeumann = std::exchange(traction, relaxed.traction);
    report(system, result, step.status, relaxed, lastJump, iteration);
  }

  /// Takes the sweeps that are done; returns the traction of the next one.
  InterfaceValues goOn(const SweepsDone& done, const InterfaceSystem& system, CouplingResult& result,
                       Ledger& ledger) const
  {
    const bool fits = int(done.traction.size()) == system.C->size() && done.state.closed.size() == system.gap.size() &&
                      done.state.tractionDirichlet.size() == done.traction.size() && !done.history.empty();
    if (!fits || !relaxation_->recall(done.relaxation))
      throw InputError("The sweeps to go on from are those of another interface, or of another Relaxation.");
    result.history = done.history;
    result.state = done.state;
    ledger.restore(done.counts, ledger.stages());
    return done.traction;
  }

  static void announce(const CouplingResult& result, const Stopping& stopping, const SweepObserver& observe,
                       Ledger& ledger)
  {
    ledger.tell(Depth::Step, stopping.progress(result.history.back()));
    observe(result.history.back(), result.state);
    ledger.count("sweeps");
  }

  /// The state but for the traction before the step, and the one after.
  static InterfaceState displacements(const DirichletStep& step, UnknownValues strainedNeumann)
  {
    InterfaceState state;
    state.uDirichlet = ofUnknowns(step.status.u);
    state.uNeumann = step.uNeumann;
    state.motionsNeumann = step.motions;
    state.strainedNeumann = std::move(strainedNeumann);
    state.forceDirichlet = ofUnknowns(step.status.force);
    state.closed = step.status.closed;
    return state;
  }

  void startRelaxation(const InterfaceSystem& system, Ledger& ledger, const CouplingStart& start) const
  {
    if (relaxation_->needsSpectrum())
      relaxation_->startWith(start.spectrum ? *start.spectrum : joinedSpectrum(roleSpectra(system, ledger)));
    else
      relaxation_->start();
  }

  InterfaceValues firstTraction(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann,
                                const CouplingStart& start) const
  {
    if (start.traction.empty())
      return initial_(system, dirichlet, neumann);
    NDFRAME_ASSERT(int(start.traction.size()) == system.C->size(), "a start needs one traction per interface node");
    return carriedTraction(system, dirichlet, neumann, start.traction);
  }

  /// Contact forces are differences of reduced loads; where bodies just touch, round-off of those is all there is.
  static bool agree(const InterfaceState& state, double loads)
  {
    return norm(difference(state.forceDirichlet, state.forceNeumann)) <= roundOff * loads;
  }

  /// Lambda_dir - Lambda_neu; empty before the first sweep.
  static Vector jumpOf(const InterfaceState& state)
  {
    return difference(state.tractionDirichlet, state.tractionNeumann);
  }

  static void report(const InterfaceSystem& system, CouplingResult& result, const UnilateralState& step,
                     const RelaxedTraction& relaxed, const Vector& lastJump,
                     const std::optional<IterationError>& iteration)
  {
    SweepRecord record = recordSweep(int(result.history.size()) + 1, system, result.state, step);
    record.epsTau = Stopping::measure(result.state.tractionDirichlet, result.state.tractionNeumann);
    if (iteration)
      record.iterationError = iteration->measure(result.state);
    record.theta = relaxed.theta;
    record.turned = !lastJump.empty() && dot(jumpOf(result.state), lastJump) < 0.0;
    if (!relaxed.note.empty())
      record.note += (record.note.empty() ? "" : "; ") + relaxed.note;
    result.history.push_back(std::move(record));
  }

  Roles roles_;
  std::shared_ptr<RelaxationController> relaxation_;
  InitialTraction initial_;
  Stopping stopping_;
};

/// The deck's values of Dirichlet Body.
const Names<Roles>& roleNames()
{
  static const Names<Roles> names{{"As Given", Roles::AsGiven}, {"Automatic", Roles::Automatic}};
  return names;
}

std::unique_ptr<Coupling> buildSweeps(const Params& p, const Registry<RelaxationController>& relaxations)
{
  const Params stopping = p.sub("Stopping");
  const Roles roles = roleNames().value(p.get<std::string>("Dirichlet Body"));
  auto controller = relaxations.build(p.sub("Relaxation"));
  const ConvergenceAdvice advice = adviceFor(*controller, roles);
  return std::make_unique<NeumannDirichlet>(
      roles, std::move(controller), initialTractions().value(p.get<std::string>("Initial Traction")),
      Stopping(stopping.get<double>("Tolerance"), stopping.get<int>("Maximum Sweeps"), advice));
}

} // namespace

void registerSweeps(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations,
                    const SweepsEntry& entry)
{
  ListSpec relaxation;
  relaxation.name = "Relaxation";
  relaxation.doc = "How the traction is relaxed from sweep to sweep, equation (27) of the paper.";
  relaxation.choices = relaxations.choices();
  registry.add(
      entry.name, entry.doc,
      {{"Initial Traction", std::string("Zero"), initialTractions().range(),
        "Traction before the first sweep: zero as in the paper, or the one that carries the resultants of the floating "
        "bodies' loads. The loads of a floating Neumann body are carried in any case."},
       {"Dirichlet Body", std::string("Automatic"), roleNames().range(),
        "Which bodies are the Dirichlet bodies: those that the interfaces name (As Given), or those with which the "
        "iteration converges faster, found from the bodies' stiffnesses on the interface; the screen says why."}},
      [&relaxations, wrap = entry.wrap](const Params& p) { return wrap(buildSweeps(p, relaxations)); },
      {relaxation, Stopping::spec()});
}

void registerNeumannDirichlet(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations)
{
  registerSweeps(registry, relaxations,
                 {neumannDirichletName,
                  "Alternates a Neumann problem on one body and a unilateral problem on the other, as in the paper. "
                  "More than two bodies must be two-colourable; chains converge slowly (docs/networks.md).",
                  [](std::unique_ptr<Coupling> sweeps) { return sweeps; }});
}

} // namespace ndframe
