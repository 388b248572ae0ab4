#include <algorithm>

#include <fmt/format.h>

#include "level_loop.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/run/contact_start.hpp"
#include "ndframe/run/run_steps.hpp"

namespace ndframe
{
namespace
{

/// Sweeps that go on make the bound fall by a tenth at least; another digit where only that may help.
constexpr double falling = 0.9, oneMoreDigit = 0.1;

/// Supports of points carry what is left of the residual, which costs the guarantee.
bool holdsPoints(const Model& model)
{
  const auto holdsPoint = [&](int body) {
    const auto& supports = model.bodies[std::size_t(body)].supports;
    return std::any_of(supports.begin(), supports.end(), [](const auto& support) { return support->holdsPoint(); });
  };
  const std::vector<int> bodies = model.elasticBodies();
  return std::any_of(bodies.begin(), bodies.end(), holdsPoint);
}

} // namespace

std::string AdaptiveRun::noteOfLevel()
{
  std::string note = planner_->note();
  if (saysShares_ && run_.model.told) {
    saysShares_ = false; // as the header of the run does where the first level is shared
    note += fmt::format("{}meshes are shared out among the {} processes from here on", note.empty() ? "" : "; ",
                        tools_.comm.size());
  }
  return note;
}

bool AdaptiveRun::carriesSolution() const
{
  const bool mayBegin =
      !run_.model.interfaces.empty() && tools_.coupling->solvesWhole(run_.model.interfaces.front().dim);
  return mayBegin && !run_.solved.fields.empty();
}

CouplingStart AdaptiveRun::presentState() const
{
  CouplingStart start;
  start.traction = nextTraction(run_);
  start.closed = run_.solved.coupling.state.closed;
  start.fields = run_.solved.coupling.state.fields;
  return start;
}

void AdaptiveRun::solveFrom(CouplingStart start, SweepsRecord& before)
{
  start.sweeps.every = restart_.sweeps;
  if (restart_.write)
    start.sweeps.keep = [&](const SweepsDone& done) { keepSweeps(before, done, start); };
  start.sweeps = sharedPasses(std::move(start.sweeps), run_.model, shared_, tools_.comm);
  solveRun(run_, tools_, silent_, start);
  isLoose_ = start.exactness == Exactness::Rough && !run_.solved.coupling.state.fields.empty();
  sweeps_ = before.before += int(run_.solved.coupling.history.size());
  certifyRun(run_, tools_);
}

/// Sweeps until their part is small beside the mesh's, and the certificate of that state. Where bodies are solved whole
/// the residual may be larger than the deck says as long as other levels follow: the bound is one of the solution as it
/// is. A level that turns out to be the last one is solved to the end.
void AdaptiveRun::solveLevel()
{
  RunObserver& observer = summary_.levels.empty() ? observer_ : silent_;
  condenseRun(run_, tools_, observer);
  findRoles(run_, tools_, observer);
  CouplingStart start = firstStart();
  for (SweepsRecord before = takeSweeps(start);;) {
    solveFrom(start, before);
    if (isLoose_ && run_.certificate && LevelErrors(run_, options_).reached())
      solveFrom(presentState(), before);
    if (!balances_ || !run_.certificate || !run_.solved.coupling.converged || run_.contradiction)
      return;
    const LevelErrors errors(run_, options_);
    const double allowed = std::min(allowedIteration(errors.mesh), errors.iterationToTarget());
    const bool mayFall = errors.mayBeOfSweeps(summary_.levels) && errors.bound < falling * before.boundBefore;
    if (errors.iteration >= before.iterationBefore || errors.iteration == 0.0 ||
        (errors.iteration <= allowed && !mayFall))
      return;
    start = presentState();
    start.iterationError = errors.iteration > allowed ? allowed : oneMoreDigit * errors.iteration;
    before.iterationBefore = errors.iteration;
    before.boundBefore = errors.bound;
  }
}

CouplingStart AdaptiveRun::firstStart() const
{
  const bool begins = carried_.interfaces.empty();
  CouplingStart start = begins ? CouplingStart() : startFrom(run_, transfer_->onto(run_.model.interfaces, carried_));
  start.iterationError = allowedIteration(expectedMesh_);
  if (!start.closed.empty())
    start.fields = solution_.onto(run_, planner_->ancestors(), tools_.comm);
  start.exactness = expectsTarget_ || holdsPoints(run_.model) ? Exactness::Full : Exactness::Rough;
  return start;
}

} // namespace ndframe
