#include "sweep.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/interface/composed_operator.hpp"

namespace ndframe
{
namespace
{

/// Adds a body's free motions, seen at the system's unknowns through `inputs`, as columns. isJump: per value of the
/// body, whether it stands for (w, d).
void appendMotions(RoleSystem& role, const BodyTrace& body, const std::vector<std::array<int, 2>>& inputs,
                   const std::vector<char>& isJump)
{
  DenseMatrix all(role.freeMotions.rows(), role.freeMotions.cols() + body.freeMotions.cols());
  std::copy_n(role.freeMotions.data(), std::size_t(all.rows()) * std::size_t(role.freeMotions.cols()), all.data());
  for (int j = 0; j < body.freeMotions.cols(); ++j)
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const double along = body.freeMotions(int(k), j);
      double* column = all.col(role.freeMotions.cols() + j);
      if (!isJump[k])
        column[inputs[k][0]] = along;
      else if (body.onDirichletSide[k])
        column[inputs[k][1]] += along;
      else {
        column[inputs[k][0]] += along;
        column[inputs[k][0] - all.rows() / 2] -= along;
      }
    }
  role.freeMotions = std::move(all);
  role.motionNames.insert(role.motionNames.end(), body.motionNames.begin(), body.motionNames.end());
}

bool hasOneRole(const InterfaceSystem& system, const BodyTrace& body)
{
  const bool isDirichlet = system.isDirichlet(body);
  return body.dependents.empty() && std::all_of(body.onDirichletSide.begin(), body.onDirichletSide.end(),
                                                [&](char side) { return bool(side) == isDirichlet; });
}

void appendLoad(RoleSystem& role, const BodyTrace& body, const std::vector<std::array<int, 2>>& inputs)
{
  for (std::size_t k = 0; k < inputs.size(); ++k)
    for (const int i : inputs[k])
      if (i >= 0)
        role.g[std::size_t(i)] += body.g[k];
}

} // namespace

bool haveRoles(const InterfaceSystem& system)
{
  return std::all_of(system.bodies.begin(), system.bodies.end(),
                     [&](const BodyTrace& body) { return hasOneRole(system, body); });
}

RoleSystem gatherRole(const InterfaceSystem& system, bool dirichlet)
{
  RoleSystem role{nullptr, Vector(std::size_t(system.size()), 0.0), DenseMatrix(system.size(), 0), {}};
  std::vector<OperatorPart> parts;
  for (const auto& body : system.bodies) {
    if (body.unknowns.empty() || system.isDirichlet(body) != dirichlet)
      continue;
    NDFRAME_ASSERT(hasOneRole(system, body),
                   "a body is the Dirichlet body of one interface and the Neumann body of another, or a Neumann body "
                   "that meets an obstacle");
    std::vector<std::array<int, 2>> inputs;
    for (const int unknown : body.unknowns)
      inputs.push_back({unknown, -1});
    appendLoad(role, body, inputs);
    appendMotions(role, body, inputs, std::vector<char>(inputs.size(), 0));
    parts.push_back({body.S, std::move(inputs)});
  }
  role.S = composeOperators(std::move(parts), system.size());
  return role;
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
  std::vector<OperatorPart> parts;
  for (const auto& body : system.bodies) {
    std::vector<std::array<int, 2>> inputs;
    std::vector<char> isJump;
    for (std::size_t k = 0; k < body.unknowns.size(); ++k) {
      const int w = body.unknowns[k], d = n + w;
      isJump.push_back(!system.isObstacle[std::size_t(w)]);
      inputs.push_back(isJump[k] ? std::array{d, body.onDirichletSide[k] ? w : -1} : std::array{w, -1});
    }
    appendLoad(role, body, inputs);
    appendMotions(role, body, inputs, isJump);
    parts.push_back({body.S, std::move(inputs)});
  }
  role.S = composeOperators(std::move(parts), 2 * n);
  return role;
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

} // namespace ndframe
