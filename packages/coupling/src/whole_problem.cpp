#include "whole_problem.hpp"

#include <algorithm>

#include "linear_start.hpp"
#include "ndframe/algebra/own_field.hpp"
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

} // namespace

bool areSolvedWhole(const InterfaceSystem& system)
{
  return std::all_of(system.bodies.begin(), system.bodies.end(),
                     [](const BodyTrace& body) { return body.isSolvedWhole(); });
}

WholeProblem::WholeProblem(const InterfaceSystem& system, const CouplingStart& start)
    : network_(unloadedNetworkOf(system)), motions_(motionNames(network_)), approach_(approachOf(network_)),
      rows_(network_), v_(std::size_t(network_.size()), 0.0), kept_(v_), exactness_(start.exactness), tolerance_(early)
{
  std::vector<const WholeSolver*> solvers;
  for (const BodyTrace* body : network_.bodies) {
    solvers.push_back(body->whole);
    loads_.push_back(body->load);
  }
  joined_ = solvers.front()->join(solvers, rows_.on(rows_.closed(std::vector<char>(network_.jump.size(), 0))));
  if (!start.fields.empty())
    begin(start.fields);
}

void WholeProblem::begin(const std::vector<NodalField>& fields)
{
  std::vector<NodalField> own;
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const BodyTrace& body = *network_.bodies[b];
    for (int k = 0; k < body.map.size(); ++k)
      kept_[std::size_t(network_.offsets[b]) + std::size_t(k)] =
          fields[b].whole()[std::size_t(body.map.dofs()[std::size_t(k)])];
    const IndexMap& nodes = body.whole->freedProblem().matrix->nodes;
    own.push_back(body.share ? body.share->own(fields[b], fields[b].width(), nodes) : ownPart(fields[b], nodes));
  }
  joined_->begin(own);
  v_ = rows_.values(kept_);
}

/// Hierarchies are made again from the set that they were made for; the largest eigenvalue is that of the open bodies.
StatusMemory WholeProblem::memory()
{
  StatusMemory memory;
  for (const NodalField& field : joined_->fields())
    if (network_.bodies[memory.fields.size()]->share)
      memory.fields.emplace_back(field.begin(), field.end());
    else
      memory.fields.push_back(onEveryRank(field, joined_->comm()).whole());
  memory.levelClosed = levelClosed_;
  memory.levelProximal = levelProximal_;
  memory.tolerance = tolerance_;
  memory.earlyPasses = earlyPasses_;
  return memory;
}

bool WholeProblem::recall(const StatusMemory& memory)
{
  bool fits = memory.fields.size() == network_.bodies.size() && memory.levelClosed.size() == network_.jump.size();
  std::vector<NodalField> fields;
  for (std::size_t b = 0; fits && b < memory.fields.size(); ++b) {
    const BlockMatrix& K = *network_.bodies[b]->whole->freedProblem().matrix;
    const auto& share = network_.bodies[b]->share;
    const IndexMap::Global nodes = share ? IndexMap::Global(share->ownNodes().size()) : K.nodes.globalSize();
    fits = IndexMap::Global(memory.fields[b].size()) == nodes * K.dim;
    if (fits)
      fields.push_back(atNodes(share ? share->spread(memory.fields[b], K.dim) : memory.fields[b], K.dim));
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
  for (NodalField& field : std::move(*joined_).takeFields())
    if (const auto& share = network_.bodies[fields.size()]->share)
      fields.push_back(atNodes(share->spread(Vector(field.begin(), field.end()), field.width()), field.width()));
    else
      fields.push_back(onEveryRank(std::move(field), joined_->comm()));
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

std::vector<char> WholeProblem::settleOnVertices(std::vector<char> first, Ledger& ledger)
{
  const auto holdsSo = [this](const std::vector<char>& closed) { return holds(closed); };
  if (!network_.hasMeans && ndframe::settleOnVertices(rows_, *joined_, loads_, holdsSo, ledger, first, levelClosed_)) {
    kept_ = joined_->beginFromVertices();
    v_ = rows_.values(kept_);
    takeMiddles(rows_, v_, first);
  }
  return first;
}

/// The kept dofs where the closed unknowns want them; what is free stays.
void WholeProblem::moveTo(const ClosedRows& closed)
{
  v_ = atStatuses(closed, v_);
  kept_ = rows_.kept(v_);
}

void WholeProblem::evaluate(const Vector& rest, StatusPass& pass) const
{
  const Vector forces = rows_.forces(rest);
  pass.unbalanced = largestEntry(closed_->reduced(forces));
  pass.force = closed_->forces(forces);
  setDisplacement(network_, v_, pass);
  for (const SparseField* load : loads_)
    pass.load = std::max(pass.load, load->largest());
  pass.roundOff = roundOff();
}

void WholeProblem::settle(double tolerance, StatusPass& pass)
{
  const Vector rest = joined_->solve(loads_, kept_, tolerance);
  v_ = rows_.values(kept_);
  evaluate(rest, pass);
}

void WholeProblem::follow(const std::vector<char>& closed, double proximal)
{
  closed_.emplace(rows_.closed(closed));
  if (joined_->follow(rows_.on(*closed_), rows_.onVertices(rows_.closedOnVertices(closed)), proximal)) {
    levelClosed_ = closed;
    levelProximal_ = proximal;
  }
}

void WholeProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  follow(closed, proximal);
  moveTo(*closed_);
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
