#pragma once

#include <functional>

#include "whole_rows.hpp"

namespace ndframe
{

/// The contact of functions that are linear between the vertices, about: a start for that of all nodes, by the same
/// active set with inexact steps, each of whose products takes a small part of one of all nodes. Statuses of conditions
/// at vertices are those that it ends with; joined.beginFromVertices() has the displacements. It ends where hardly any
/// status is wrong, or where a set comes back: what it leaves is only a start.
///
/// holds: whether closed conditions stop all motions. False where there is nothing to start from: no condition belongs
/// to a vertex, or the loads do not press the bodies together; `closed` is then as it was. Counts "vertex passes".
/// levelClosed: becomes the statuses for which the coarse level was set up last, if it was.
bool settleOnVertices(const WholeRows& rows, JoinedSystem& joined, const std::vector<const SparseField*>& loads,
                      const std::function<bool(const std::vector<char>&)>& holds, Ledger& ledger,
                      std::vector<char>& closed, std::vector<char>& levelClosed);

/// Statuses at the middles of edges from those at their ends and the gap of v: closed between closed ends, and where
/// bodies penetrate; elsewhere open.
void takeMiddles(const WholeRows& rows, const Vector& v, std::vector<char>& closed);

/// v with the closed conditions as equations; what is free stays.
Vector atStatuses(const ClosedRows& closed, const Vector& v);

} // namespace ndframe
