#include <utility>

#include "initial_traction.hpp"
#include "ndframe/subdomain/neumann_problem.hpp"
#include "stopping.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

Vector sum(Vector a, const Vector& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += b[i];
  return a;
}

/// The Neumann-Dirichlet algorithm of section 4.2.3: Neumann problem on body 2 (25), unilateral problem on body 1 (26),
/// relaxed update of the traction (27), until eps_tau is small. Bayada, Sabil and Sassi (2002) prove convergence for
/// small theta.
///
/// Limits: a body is Dirichlet or Neumann body on all its interfaces; the Neumann bodies must be held by their
/// supports. The factor of convergence is about 1 - theta (1 + mu), mu the ratio of the Dirichlet to the Neumann body's
/// stiffness.
class NeumannDirichlet final : public Coupling
{
public:
  NeumannDirichlet(std::shared_ptr<RelaxationController> relaxation, InitialTraction initial, Stopping stopping)
      : relaxation_(std::move(relaxation)), initial_(initial), stopping_(stopping)
  {}

  bool alternates() const override { return true; }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger) const override
  {
    const RoleSystem body1 = gatherRole(system, true), body2 = gatherRole(system, false);
    const NeumannProblem neumann(*body2.S, body2.g, ledger);
    UnilateralProblem dirichlet(*body1.S, std::vector<char>(std::size_t(system.size()), 1), body1.freeMotions,
                                body1.motionNames, ledger);
    CouplingResult result;
    Vector traction = initial_(system, body1);
    std::vector<char> closed(std::size_t(system.size()), 1);
    relaxation_->start();
    do {
      const Vector force = system.force(traction);
      Vector u2;
      UnilateralState step;
      try {
        u2 = neumann.solve(force);                                    // (25)
        step = dirichlet.solve(body1.g, sum(u2, system.gap), closed); // (26)
      } catch (const NotConverged& failure) {
        if (result.history.empty())
          throw;
        result.reason = failure.what();
        return result;
      }
      const Vector stepTraction = system.traction(step.force);
      auto relaxed = relaxation_->next(stepTraction, traction); // (27)
      result.state = {step.u,     u2, step.force, force, stepTraction, std::exchange(traction, relaxed.traction),
                      step.closed};
      closed = step.closed;
      report(system, result, step, relaxed);
      observe(result.history.back(), result.state);
      ledger.count("sweeps");
    } while (!stopping_.ends(result));
    return result;
  }

private:
  static void report(const InterfaceSystem& system, CouplingResult& result, const UnilateralState& step,
                     const RelaxedTraction& relaxed)
  {
    SweepRecord record = recordSweep(int(result.history.size()) + 1, system, result.state, step);
    record.epsTau = Stopping::measure(result.state.tractionDirichlet, result.state.tractionNeumann);
    record.theta = relaxed.theta;
    if (!relaxed.note.empty())
      record.note += (record.note.empty() ? "" : "; ") + relaxed.note;
    result.history.push_back(std::move(record));
  }

  std::shared_ptr<RelaxationController> relaxation_;
  InitialTraction initial_;
  Stopping stopping_;
};

} // namespace

void registerNeumannDirichlet(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations)
{
  ListSpec relaxation;
  relaxation.name = "Relaxation";
  relaxation.doc = "How the traction is relaxed from sweep to sweep, (27).";
  relaxation.choices = relaxations.choices();
  registry.add(
      "Neumann-Dirichlet",
      "Alternates a Neumann problem on one body and a unilateral problem on the other, as in the paper.",
      {{"Initial Traction", std::string("Zero"), initialTractions().range(),
        "Traction before the first sweep: zero as in the paper, or the one that carries the resultant of a floating "
        "Dirichlet body's loads."}},
      [&relaxations](const Params& p) {
        const Params stopping = p.sub("Stopping");
        return std::make_unique<NeumannDirichlet>(
            relaxations.build(p.sub("Relaxation")), initialTractions().value(p.get<std::string>("Initial Traction")),
            Stopping(stopping.get<double>("Tolerance"), stopping.get<int>("Maximum Sweeps")));
      },
      {relaxation, Stopping::spec()});
}

} // namespace ndframe
