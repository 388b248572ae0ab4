#pragma once

#include <array>

#include "ndframe/algebra/joined_system.hpp"
#include "network.hpp"

namespace ndframe
{

/// Closed conditions of a network as rows for the kept dofs of bodies that are solved whole, on all nodes and for
/// linear functions on the vertices.
///
/// A condition belongs to a vertex where all its entries do, or, if it is no mean, the entry of a side that has one
/// only; entries of the other side at the middle of an edge are then half of each end: linear functions have such
/// coefficients, but for normals that turn along the edge.
class WholeRows
{
public:
  /// network: must outlive this; its bodies must be solved whole.
  explicit WholeRows(const Network& network);

  ClosedRows closed(const std::vector<char>& statuses) const;
  ClosedRows closedOnVertices(const std::vector<char>& statuses) const;
  /// kept = A^-1 Z y and y = A kept at the places of the entries of v that are free.
  JoinedRows on(const ClosedRows& closed) const { return rows(closed, false); }
  JoinedRows onVertices(const ClosedRows& closed) const { return rows(closed, true); }

  const Network& network() const { return network_; }
  const std::vector<char>& atVertex() const { return hasVertex_; } ///< per condition, whether it belongs to one
  /// Per condition those at the ends of its edge (itself: at a vertex), -1: none, or not known.
  const std::vector<std::array<int, 2>>& ends() const { return ends_; }
  const std::vector<SparseRow>& vertexJump() const { return vertexJump_; } ///< as Network::jump; empty where at none

  Vector values(const Vector& kept) const; ///< v from the kept dofs of all bodies
  Vector kept(const Vector& v) const;      ///< and back
  Vector forces(const Vector& rest) const; ///< on the entries of v. rest: load - K u, per kept dof

private:
  void findEntries();
  void findConditions();
  int singleEntry(std::size_t condition) const;
  bool isVertex(int entry) const { return entry >= 0 && entryEnds_[std::size_t(entry)][0] == entry; }
  SparseRow rowOnVertices(std::size_t condition) const;
  JoinedRows rows(const ClosedRows& closed, bool onVertices) const;

  const Network& network_;
  std::vector<std::array<int, 2>>
      entryEnds_; ///< per entry of v those at the ends of its edge (itself: a vertex), -1: none
  std::vector<char> hasVertex_;
  std::vector<std::array<int, 2>> ends_;
  std::vector<SparseRow> vertexJump_;
};

} // namespace ndframe
