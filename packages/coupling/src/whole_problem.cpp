#include "whole_problem.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double early = 1e-2;        ///< the residual that is enough to see which statuses change
constexpr int mostEarlyPasses = 30;   ///< more of them go round in circles
constexpr double amplification = 1e2; ///< of the tolerance: what single forces may be wrong by, relative to the largest

/// Per unknown, what the free motions of all bodies do to the distance of both sides.
DenseMatrix approachOf(const Network& network)
{
  DenseMatrix result(int(network.jump.size()), int(motionNames(network).size()));
  for (std::size_t b = 0, first = 0; b < network.bodies.size(); ++b) {
    const DenseMatrix& motions = network.bodies[b]->freeMotions;
    for (std::size_t i = 0; i < network.jump.size(); ++i)
      for (const auto& [entry, share] : network.jump[i])
        for (int m = 0; network.offsets[b] <= entry && entry < network.offsets[b + 1] && m < motions.cols(); ++m)
          result(int(i), int(first) + m) += share * motions(entry - network.offsets[b], m);
    first += std::size_t(motions.cols());
  }
  return result;
}

std::vector<char> entriesAtVertices(const Network& network)
{
  std::vector<char> result;
  for (const BodyTrace* body : network.bodies) {
    const SolverProblem& problem = body->whole->freedProblem();
    for (const int dof : body->map.dofs()) {
      const auto& ends = problem.edgeNodes.ends[std::size_t(dof / problem.matrix->dim)];
      result.push_back(ends[0] == ends[1]);
    }
  }
  return result;
}

} // namespace

bool areSolvedWhole(const InterfaceSystem& system)
{
  return std::all_of(system.bodies.begin(), system.bodies.end(),
                     [](const BodyTrace& body) { return body.isSolvedWhole(); });
}

WholeProblem::WholeProblem(const InterfaceSystem& system, const CouplingStart& start)
    : network_(unloadedNetworkOf(system)), motions_(motionNames(network_)), approach_(approachOf(network_)),
      atVertex_(entriesAtVertices(network_)), v_(std::size_t(network_.size()), 0.0), kept_(v_),
      exactness_(start.exactness), tolerance_(early)
{
  std::vector<const WholeSolver*> solvers;
  for (const BodyTrace* body : network_.bodies) {
    solvers.push_back(body->whole);
    loads_.push_back(body->load);
  }
  joined_ =
      solvers.front()->join(solvers, rowsFor(ClosedRows(network_.jump, {}, network_.bound, network_.size()), false));
  std::vector<const Vector*> fields;
  for (const NodalField& field : start.fields)
    fields.push_back(&field.whole());
  if (!fields.empty())
    begin(fields);
}

void WholeProblem::begin(const std::vector<const Vector*>& fields)
{
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const TraceMap& map = network_.bodies[b]->map;
    for (int k = 0; k < map.size(); ++k)
      kept_[std::size_t(network_.offsets[b]) + std::size_t(k)] = (*fields[b])[std::size_t(map.dofs()[std::size_t(k)])];
  }
  joined_->begin(fields);
  takeKept();
}

/// Hierarchies are made again from the set that they were made for; the largest eigenvalue is that of the open bodies.
StatusMemory WholeProblem::memory()
{
  StatusMemory memory;
  memory.fields = joined_->fields();
  memory.levelClosed = levelClosed_;
  memory.levelProximal = levelProximal_;
  memory.tolerance = tolerance_;
  memory.earlyPasses = earlyPasses_;
  return memory;
}

bool WholeProblem::recall(const StatusMemory& memory)
{
  bool fits = memory.fields.size() == network_.bodies.size() && memory.levelClosed.size() == network_.jump.size();
  std::vector<const Vector*> fields;
  for (std::size_t b = 0; fits && b < memory.fields.size(); ++b) {
    fields.push_back(&memory.fields[b]);
    fits = int(fields.back()->size()) == network_.bodies[b]->whole->freedProblem().matrix->numDofs();
  }
  if (!fits)
    return false;
  begin(fields);
  follow(memory.levelClosed, memory.levelProximal);
  tolerance_ = memory.tolerance;
  earlyPasses_ = memory.earlyPasses;
  return true;
}

std::vector<NodalField> WholeProblem::takeFields() &&
{
  std::vector<NodalField> fields;
  for (Vector& values : std::move(*joined_).takeFields())
    fields.push_back(atNodes(std::move(values), loads_.front()->width()));
  return fields;
}

double WholeProblem::roundOff() const
{
  return std::max(statusRoundOff, amplification * finest());
}

bool WholeProblem::holds(const std::vector<char>& closed)
{
  DenseMatrix held = approach_;
  for (int i = 0; i < held.rows(); ++i)
    for (int m = 0; !closed[std::size_t(i)] && m < held.cols(); ++m)
      held(i, m) = 0.0;
  return held.cols() == 0 || nullSpace(held, rigidTolerance).cols() == 0;
}

ClosedRows WholeProblem::closedOnVertices(const std::vector<char>& closed) const
{
  std::vector<int> chosen;
  for (const int i : tightestFirst(network_, closed)) {
    const SparseRow& row = network_.jump[std::size_t(i)];
    if (std::all_of(row.begin(), row.end(), [&](const auto& entry) { return isAtVertex(std::size_t(entry.first)); }))
      chosen.push_back(i);
  }
  return {network_.jump, chosen, network_.bound, network_.size()};
}

/// kept = A^-1 Z y and y = A kept at the places of the entries of v that are free. At vertices rows of A and A^-1 have
/// entries at vertices only, for coefficients there are values.
JoinedRows WholeProblem::rowsFor(const ClosedRows& closed, bool onVertices) const
{
  std::vector<int> place(std::size_t(closed.numFree()));
  for (std::size_t entry = 0; entry < closed.freeNumber().size(); ++entry)
    if (closed.freeNumber()[entry] >= 0)
      place[std::size_t(closed.freeNumber()[entry])] = int(entry);
  JoinedRows rows;
  SparseSum sum(network_.size());
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const int first = network_.offsets[b];
    const TraceMap& map = network_.bodies[b]->map;
    for (int k = 0; k < map.size(); ++k) {
      rows.kept.emplace_back();
      rows.unknowns.emplace_back();
      const auto entry = std::size_t(first) + std::size_t(k);
      if (onVertices && !isAtVertex(entry))
        continue;
      for (const auto& [l, share] : map.inverse()[std::size_t(k)])
        for (const auto& [number, part] : closed.inFree(first + l))
          sum.add(place[std::size_t(number)], share * part);
      rows.kept.back() = sum.take();
      if (closed.freeNumber()[entry] >= 0)
        for (const auto& [l, share] : map.rows()[std::size_t(k)])
          rows.unknowns.back().emplace_back(first + l, share);
    }
  }
  return rows;
}

/// The kept dofs where the closed unknowns want them; what is free stays.
void WholeProblem::moveToStatuses()
{
  Vector free(std::size_t(rows_->numFree()));
  for (std::size_t entry = 0; entry < v_.size(); ++entry)
    if (const int number = rows_->freeNumber()[entry]; number >= 0)
      free[std::size_t(number)] = v_[entry];
  v_ = rows_->expanded(free);
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const TraceMap& map = network_.bodies[b]->map;
    const Vector kept = map.keptValues({v_.begin() + network_.offsets[b], v_.begin() + network_.offsets[b + 1]});
    std::copy(kept.begin(), kept.end(), kept_.begin() + network_.offsets[b]);
  }
}

/// On the entries of v. rest: per kept dof.
Vector WholeProblem::forcesOn(const Vector& rest) const
{
  Vector all;
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const TraceMap& map = network_.bodies[b]->map;
    Vector kept;
    for (int k = 0; k < map.size(); ++k)
      kept.push_back(-rest[std::size_t(network_.offsets[b]) + std::size_t(k)]);
    const Vector own = map.forces(kept);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

void WholeProblem::evaluate(const Vector& rest, StatusPass& pass) const
{
  const Vector forces = forcesOn(rest);
  pass.unbalanced = largestEntry(rows_->reduced(forces));
  pass.force = rows_->forces(forces);
  setDisplacement(network_, v_, pass);
  for (const SparseField* load : loads_)
    pass.load = std::max(pass.load, load->largest());
  pass.roundOff = roundOff();
}

void WholeProblem::settle(double tolerance, StatusPass& pass)
{
  const Vector rest = joined_->solve(loads_, kept_, tolerance);
  takeKept();
  evaluate(rest, pass);
}

/// The entries of v that the kept dofs stand for.
void WholeProblem::takeKept()
{
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const TraceMap& map = network_.bodies[b]->map;
    const Vector values = map.values({kept_.begin() + network_.offsets[b], kept_.begin() + network_.offsets[b + 1]});
    std::copy(values.begin(), values.end(), v_.begin() + network_.offsets[b]);
  }
}

void WholeProblem::follow(const std::vector<char>& closed, double proximal)
{
  rows_.emplace(network_.jump, tightestFirst(network_, closed), network_.bound, network_.size());
  if (joined_->follow(rowsFor(*rows_, false), rowsFor(closedOnVertices(closed), true), proximal)) {
    levelClosed_ = closed;
    levelProximal_ = proximal;
  }
}

void WholeProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  follow(closed, proximal);
  moveToStatuses();
  pass.isFinal = proximal > 0.0 || tolerance_ <= finest();
  settle(pass.isFinal ? finest() : tolerance_, pass);
  if (pass.isFinal)
    return;
  const std::size_t wrong = violations(pass, std::vector<char>(closed.size(), 1), network_.bound, closed).size();
  if (wrong > 0 && ++earlyPasses_ < mostEarlyPasses) {
    tolerance_ =
        std::max(finest(), std::min(tolerance_, early * std::min(1.0, 10.0 * double(wrong) / double(closed.size()))));
    return;
  }
  tolerance_ = finest();
  pass.isFinal = true;
  settle(finest(), pass);
}

} // namespace ndframe
