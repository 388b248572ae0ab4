#include "ndframe/coupling/rigid_network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{
namespace
{

constexpr double noWork = 1e-7;   ///< of the absolute work of the loads along the same motion
constexpr double opened = 1e-7;   ///< a node that parts by less, where motions are at most 1, stays
constexpr double roundOff = 1e-9; ///< entries of a motion that are none, relative to its largest

double along(const SparseRow& row, const Vector& a)
{
  return std::accumulate(row.begin(), row.end(), 0.0, [&](double sum, const auto& entry) {
    return sum + entry.second * a[std::size_t(entry.first)];
  });
}

/// w with a largest entry of 1, as a row; empty without loads.
SparseRow workRow(const RigidNetwork& network)
{
  const double scale = largestEntry(network.magnitude);
  SparseRow row;
  for (int j = 0; j < network.size(); ++j)
    if (network.work[std::size_t(j)] != 0.0)
      row.emplace_back(j, network.work[std::size_t(j)] / scale);
  return row;
}

/// |a_j| <= 1, B R a <= 0; a cost is to be given.
LinearProgram overTheCone(const RigidNetwork& network)
{
  const auto motions = std::size_t(network.size()), rows = network.approach.size();
  return {Vector(motions, 0.0), Vector(motions, -1.0),    Vector(motions, 1.0),
          network.approach,     Vector(rows, -unbounded), Vector(rows, 0.0)};
}

void addWork(LinearProgram& program, SparseRow work, double least)
{
  program.rows.push_back(std::move(work));
  program.rowLower.push_back(least);
  program.rowUpper.push_back(unbounded);
}

/// The motion without negative work that parts the sides of all nodes most in sum.
Vector mostParting(const RigidNetwork& network)
{
  LinearProgram program = overTheCone(network);
  for (const SparseRow& row : network.approach)
    for (const auto& [motion, value] : row)
      program.cost[std::size_t(motion)] -= value;
  addWork(program, workRow(network), 0.0);
  return solve(program).value_or(Vector(program.cost.size(), 0.0));
}

Vector mostWork(const RigidNetwork& network)
{
  LinearProgram program = overTheCone(network);
  for (const auto& [motion, value] : workRow(network))
    program.cost[std::size_t(motion)] = value;
  return solve(program).value_or(Vector(program.cost.size(), 0.0));
}

/// Takes round-off out of a motion and makes its largest entry 1.
Vector cleaned(Vector a)
{
  const double largest = largestEntry(a);
  for (double& value : a)
    value = std::abs(value) <= roundOff * largest ? 0.0 : value / largest;
  return a;
}

/// Whether the motion with the most work has any: a true one goes on to the bounds.
bool works(const RigidNetwork& network, const Vector& most)
{
  if (largestEntry(most) < 1.0 - noWork)
    return false;
  const Vector a = cleaned(most);
  double sizes = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j)
    sizes += network.magnitude[j] * std::abs(a[j]);
  return dot(network.work, a) > noWork * sizes;
}

/// The motion with the least sum of reluctance_j |a_j| that meets the rows of a program; the known one if there is
/// none.
Vector simplest(const RigidNetwork& network, const LinearProgram& program, const Vector& known)
{
  const auto motions = std::size_t(network.size());
  LinearProgram split = program; // a = x - y, x and y >= 0
  for (std::size_t j = 0; j < motions; ++j)
    split.cost[j] = -network.reluctance[j];
  split.cost.insert(split.cost.end(), split.cost.begin(), split.cost.end());
  split.lower.assign(2 * motions, 0.0);
  split.upper.insert(split.upper.end(), split.upper.begin(), split.upper.end());
  for (SparseRow& row : split.rows)
    for (std::size_t k = 0, entries = row.size(); k < entries; ++k)
      row.emplace_back(row[k].first + network.size(), -row[k].second);
  const auto solution = solve(split);
  if (!solution)
    return cleaned(known);
  Vector a(solution->begin(), solution->begin() + std::ptrdiff_t(motions));
  for (std::size_t j = 0; j < motions; ++j)
    a[j] -= (*solution)[motions + j];
  return cleaned(std::move(a));
}

/// As much work as `known`, and nothing moves that need not.
Vector simplestWithWork(const RigidNetwork& network, const Vector& known)
{
  LinearProgram program = overTheCone(network);
  const SparseRow work = workRow(network);
  addWork(program, work, (1.0 - noWork) * along(work, known));
  return simplest(network, program, known);
}

/// Of the motions that part all nodes that are not closed; `known` is one that parts some.
Vector simplestParting(const RigidNetwork& network, const std::vector<char>& closed, const Vector& known)
{
  LinearProgram program = overTheCone(network);
  program.upper.assign(program.upper.size(), unbounded);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    program.rowUpper[i] = closed[i] ? 0.0 : -1.0;
    program.rowLower[i] = closed[i] ? 0.0 : -unbounded;
  }
  return simplest(network, program, known);
}

/// The nodes that no motion without work parts. With the opening t_i <= 1 of each: B R a + t <= 0, and as motions may
/// be added and multiplied, a largest sum of t has t_i = 1 wherever it can be above 0.
std::vector<char> closedNodes(const RigidNetwork& network)
{
  const std::size_t nodes = network.approach.size();
  LinearProgram program = overTheCone(network);
  program.lower.assign(program.lower.size(), -unbounded);
  program.upper.assign(program.upper.size(), unbounded);
  for (std::size_t i = 0; i < nodes; ++i)
    program.rows[i].emplace_back(network.size() + int(i), 1.0);
  program.cost.resize(program.cost.size() + nodes, 1.0);
  program.lower.resize(program.cost.size(), 0.0);
  program.upper.resize(program.cost.size(), 1.0);
  addWork(program, workRow(network), 0.0);
  const auto solution = solve(program);
  std::vector<char> closed(nodes, 1);
  for (std::size_t i = 0; solution && i < nodes; ++i)
    closed[i] = char((*solution)[std::size_t(network.size()) + i] < 0.5);
  return closed;
}

/// A motion that contact lets go on for ever and that the loads do not resist; empty when there is none.
Vector unstopped(const RigidNetwork& network)
{
  Vector parting = mostParting(network);
  const bool parts = std::any_of(network.approach.begin(), network.approach.end(),
                                 [&](const SparseRow& row) { return along(row, parting) < -opened; });
  return parts ? parting : Vector();
}

} // namespace

Vector pulledOff(const RigidNetwork& network)
{
  if (network.size() == 0 || unstopped(network).empty())
    return {};
  const Vector working = mostWork(network);
  return works(network, working) ? simplestWithWork(network, working) : Vector();
}

Vector loose(const RigidNetwork& network)
{
  if (network.size() == 0)
    return {};
  const Vector parting = unstopped(network);
  if (parting.empty() || works(network, mostWork(network)))
    return {};
  return simplestParting(network, closedNodes(network), parting);
}

} // namespace ndframe
