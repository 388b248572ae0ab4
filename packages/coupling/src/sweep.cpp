#include "sweep.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/interface/congruence.hpp"

namespace ndframe
{
namespace
{

/// Adds a body's free motions at the system's unknowns as columns. isJump: per value of the body, whether it stands for
/// (w, d).
void appendMotions(RoleSystem& role, const BodyTrace& body, const std::vector<char>& isJump)
{
  DenseMatrix all(role.freeMotions.rows(), role.freeMotions.cols() + body.freeMotions.cols());
  std::copy_n(role.freeMotions.data(), std::size_t(all.rows()) * std::size_t(role.freeMotions.cols()), all.data());
  for (int j = 0; j < body.freeMotions.cols(); ++j)
    for (std::size_t k = 0; k < body.unknowns.size(); ++k) {
      const double along = body.freeMotions(int(k), j);
      double* w = all.col(role.freeMotions.cols() + j) + body.unknowns[k];
      if (!isJump[k] || body.roles[k] == ContactRole::Dirichlet)
        *w += along;
      else {
        *w -= along;
        w[all.rows() / 2] += along; // d
      }
    }
  role.freeMotions = std::move(all);
  role.motionNames.insert(role.motionNames.end(), body.motionNames.begin(), body.motionNames.end());
}

bool hasOneRole(const InterfaceSystem& system, const BodyTrace& body)
{
  const ContactRole one = system.roleOf(body);
  return body.dependents.empty() &&
         std::all_of(body.roles.begin(), body.roles.end(), [one](ContactRole role) { return role == one; });
}

/// Adds a body whose values are P x.
void append(RoleSystem& role, const BodyTrace& body, std::vector<SparseRow> P, const std::vector<char>& isJump,
            std::vector<CongruencePart>& parts)
{
  const Vector& g = body.g;
  for (std::size_t k = 0; k < P.size(); ++k)
    for (const auto& [i, coefficient] : P[k])
      role.g[std::size_t(i)] += coefficient * g[k];
  appendMotions(role, body, isJump);
  parts.push_back({body.S, std::move(P)});
}

} // namespace

bool haveRoles(const InterfaceSystem& system)
{
  if (system.mortar)
    return false;
  return std::all_of(system.bodies.begin(), system.bodies.end(),
                     [&](const BodyTrace& body) { return hasOneRole(system, body); });
}

RoleSystem gatherRole(const InterfaceSystem& system, ContactRole role)
{
  RoleSystem gathered{nullptr, Vector(std::size_t(system.size()), 0.0), DenseMatrix(system.size(), 0), {}};
  std::vector<CongruencePart> parts;
  for (const auto& body : system.bodies) {
    if (body.unknowns.empty() || system.roleOf(body) != role)
      continue;
    NDFRAME_ASSERT(hasOneRole(system, body),
                   "a body is the Dirichlet body of one interface and the Neumann body of another, or a Neumann body "
                   "that meets an obstacle");
    std::vector<SparseRow> P;
    for (const int unknown : body.unknowns)
      P.push_back({{unknown, 1.0}});
    append(gathered, body, std::move(P), std::vector<char>(body.unknowns.size(), 0), parts);
  }
  gathered.S = congruence(std::move(parts), system.size());
  return gathered;
}

DenseMatrix motionsAtRest(const DenseMatrix& motions, const std::vector<char>& isHeld)
{
  DenseMatrix held(motions.rows(), motions.cols());
  bool any = false;
  for (int i = 0; i < held.rows(); ++i)
    for (int j = 0; isHeld[std::size_t(i)] && j < held.cols(); ++j) {
      held(i, j) = motions(i, j);
      any = true;
    }
  if (!any)
    return motions;
  DenseMatrix rest = multiply(motions, nullSpace(held, rigidTolerance));
  for (int i = 0; i < rest.rows(); ++i)
    for (int j = 0; isHeld[std::size_t(i)] && j < rest.cols(); ++j)
      rest(i, j) = 0.0; // but for round-off
  return rest;
}

RoleSystem gatherJump(const InterfaceSystem& system)
{
  const int n = system.size();
  RoleSystem role{nullptr, Vector(2 * std::size_t(n), 0.0), DenseMatrix(2 * n, 0), {}};
  std::vector<CongruencePart> parts;
  for (const auto& body : system.bodies) {
    std::vector<SparseRow> P;
    std::vector<char> isJump;
    for (std::size_t k = 0; k < body.unknowns.size(); ++k) {
      const int w = body.unknowns[k], d = n + w;
      isJump.push_back(!system.isObstacle[std::size_t(w)]);
      P.emplace_back();
      if (isJump[k])
        P.back().emplace_back(d, 1.0);
      if (!isJump[k] || body.roles[k] == ContactRole::Dirichlet)
        P.back().emplace_back(w, 1.0);
    }
    append(role, body, std::move(P), isJump, parts);
  }
  role.S = congruence(std::move(parts), 2 * n);
  return role;
}

PassesKept passesOf(const SweepsKept& sweeps)
{
  PassesKept kept;
  if (sweeps.after && !sweeps.after->passes)
    throw InputError("The sweeps to go on from are those of another coupling.");
  kept.after = sweeps.after ? &*sweeps.after->passes : nullptr;
  if (sweeps.every > 0 && sweeps.keep)
    kept.keep = [&sweeps](const StatusPasses& done) {
      SweepsDone all;
      all.passes = done;
      sweeps.keep(all);
    };
  return kept;
}

std::vector<char> firstStatuses(const InterfaceSystem& system, bool floats, const CouplingStart& start)
{
  if (!start.closed.empty()) {
    NDFRAME_ASSERT(int(start.closed.size()) == system.size(), "a start needs one status per unknown");
    return start.closed;
  }
  const bool mayTouch =
      floats || std::any_of(system.gap.begin(), system.gap.end(), [](double gap) { return !(gap > 0.0); });
  return std::vector<char>(std::size_t(system.size()), char(mayTouch));
}

bool areApart(const SweepRecord& last)
{
  return last.closed == 0 && last.open > 0 && last.epsTau == 0.0;
}

SweepRecord recordSweep(int sweep, const InterfaceSystem& system, const InterfaceState& state,
                        const UnilateralState& status)
{
  SweepRecord record;
  record.sweep = sweep;
  record.statusChanges = status.changes;
  record.statusPasses = status.passes;
  record.closed = int(std::count(state.closed.begin(), state.closed.end(), char(1)));
  record.open = system.size() - record.closed;
  record.forceDirichlet = std::accumulate(state.forceDirichlet.begin(), state.forceDirichlet.end(), 0.0);
  record.forceNeumann = std::accumulate(state.forceNeumann.begin(), state.forceNeumann.end(), 0.0);
  for (std::size_t i = 0; i < state.closed.size(); ++i)
    record.penetration = std::max(record.penetration, state.uDirichlet[i] - state.uNeumann[i] - system.gap[i]);
  if (status.cycled)
    record.note = "the status method cycled; finished one node at a time";
  return record;
}

CouplingResult settled(const InterfaceSystem& system, InterfaceState state, const UnilateralState& status,
                       const std::string& reason)
{
  CouplingResult result;
  result.history.push_back(recordSweep(1, system, state, status));
  result.state = std::move(state);
  result.converged = true;
  result.reason = areApart(result.history.back()) ? apart : reason;
  return result;
}

} // namespace ndframe
