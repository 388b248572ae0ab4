#include "whole_rows.hpp"

#include <algorithm>
#include <unordered_map>

namespace ndframe
{
namespace
{

/// What `action` makes of the bodies' parts of a stacked vector, stacked.
template <class Action>
Vector bodyByBody(const Network& network, const Vector& all, const Action& action)
{
  Vector result;
  for (std::size_t b = 0; b < network.bodies.size(); ++b) {
    const Vector own =
        action(network.bodies[b]->map, {all.begin() + network.offsets[b], all.begin() + network.offsets[b + 1]});
    result.insert(result.end(), own.begin(), own.end());
  }
  return result;
}

} // namespace

WholeRows::WholeRows(const Network& network) : network_(network)
{
  findEntries();
  findConditions();
}

void WholeRows::findEntries()
{
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const BodyTrace& body = *network_.bodies[b];
    const RankProblem& problem = body.whole->freedProblem();
    const int dim = problem.matrix->dim;
    std::unordered_map<RankProblem::Global, int> entryOf; ///< per kept dof
    for (std::size_t k = 0; k < problem.kept.size(); ++k)
      entryOf[problem.kept[k]] = network_.offsets[b] + int(k);
    for (std::size_t k = 0; k < problem.kept.size(); ++k) {
      entryEnds_.emplace_back();
      for (std::size_t end = 0; end < 2; ++end) {
        const auto found = entryOf.find(problem.keptEnds[k][end] * dim + problem.kept[k] % dim);
        entryEnds_.back()[end] = found == entryOf.end() ? -1 : found->second;
      }
    }
  }
}

/// The entry of a side that has one only, -1 where both have several.
int WholeRows::singleEntry(std::size_t condition) const
{
  for (const auto* side : {&network_.dirichlet, &network_.neumann})
    if (const SparseRow& row = (*side)[condition]; row.size() == 1)
      return row.front().first;
  return -1;
}

/// Empty where the condition belongs to no vertex.
SparseRow WholeRows::rowOnVertices(std::size_t condition) const
{
  const SparseRow& row = network_.jump[condition];
  if (std::all_of(row.begin(), row.end(), [&](const auto& entry) { return isVertex(entry.first); }))
    return row;
  if (network_.hasMeans || !isVertex(singleEntry(condition)))
    return {};
  SparseSum sum(network_.size());
  for (const auto& [entry, share] : row)
    for (const int end : entryEnds_[std::size_t(entry)])
      if (isVertex(end))
        sum.add(end, 0.5 * share);
  return sum.take();
}

void WholeRows::findConditions()
{
  std::vector<int> conditionOf(entryEnds_.size(), -1);
  for (std::size_t i = 0; i < network_.jump.size(); ++i) {
    vertexJump_.push_back(rowOnVertices(i));
    hasVertex_.push_back(!vertexJump_.back().empty());
    if (const int entry = singleEntry(i); hasVertex_.back() && entry >= 0)
      conditionOf[std::size_t(entry)] = int(i);
  }
  for (std::size_t i = 0; i < network_.jump.size(); ++i) {
    ends_.push_back({-1, -1});
    const int entry = singleEntry(i);
    for (std::size_t end = 0; entry >= 0 && end < 2; ++end)
      if (const int vertex = entryEnds_[std::size_t(entry)][end]; vertex >= 0)
        ends_.back()[end] = conditionOf[std::size_t(vertex)];
  }
}

ClosedRows WholeRows::closed(const std::vector<char>& statuses) const
{
  return {network_.jump, tightestFirst(network_, statuses), network_.bound, network_.size()};
}

ClosedRows WholeRows::closedOnVertices(const std::vector<char>& statuses) const
{
  std::vector<int> chosen;
  for (const int i : tightestFirst(network_, statuses))
    if (hasVertex_[std::size_t(i)])
      chosen.push_back(i);
  return {vertexJump_, chosen, network_.bound, network_.size()};
}

/// At vertices rows of A and A^-1 have entries at vertices only, for coefficients there are values.
JoinedRows WholeRows::rows(const ClosedRows& closed, bool onVertices) const
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
      if (onVertices && entryEnds_[entry][0] != int(entry))
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

Vector WholeRows::values(const Vector& kept) const
{
  return bodyByBody(network_, kept, [](const TraceMap& map, const Vector& own) { return map.values(own); });
}

Vector WholeRows::kept(const Vector& v) const
{
  return bodyByBody(network_, v, [](const TraceMap& map, const Vector& own) { return map.keptValues(own); });
}

Vector WholeRows::forces(const Vector& rest) const
{
  return bodyByBody(network_, rest, [](const TraceMap& map, Vector own) {
    for (double& force : own)
      force = -force;
    return map.forces(own);
  });
}

} // namespace ndframe
