#pragma once

#include <vector>

#include "ndframe/algebra/index_map.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/fem/node_map.hpp"

namespace ndframe
{

/// What a rank has of a body whose mesh no rank has: the cells around its own nodes, and others that all ranks have.
/// Nodes and cells of the part are numbered by themselves; each node and each cell is one rank's own.
class BodyShare
{
public:
  using Global = IndexMap::Global;

  /// numNodes, numCells: of the whole body. numbers: per node of the part that of the whole body, ascending. owners:
  /// per node of the part, the rank. The first numOwnCells cells are the rank's own. Collective.
  BodyShare(Global numNodes, Global numCells, std::vector<Global> numbers, std::vector<int> owners, int numOwnCells,
            const Comm& comm);

  Global numNodes() const { return numNodes_; } ///< of the whole body
  Global numCells() const { return numCells_; } ///< of the whole body
  int numOwnCells() const { return numOwnCells_; }
  bool owns(int node) const { return owners_[std::size_t(node)] == rank_; }
  const std::vector<Global>& numbers() const { return numbers_; } ///< per node of the part
  std::vector<int> ownNodes() const;                              ///< of the part, ascending
  /// Values of nodes of the part, `width` for each, become those of their owners. Collective among neighbours.
  void fetch(Vector& values, int width) const;
  /// Values at other ranks' nodes become zero.
  void annulOthers(Vector& values, int width) const;
  /// Values at own nodes, ascending, from those of the part, and back with zeros elsewhere.
  Vector own(const Vector& values, int width) const;
  Vector spread(const Vector& own, int width) const; ///< fetches the other ranks' values. Collective

private:
  Global numNodes_, numCells_;
  std::vector<Global> numbers_;
  std::vector<int> owners_;
  int numOwnCells_, rank_;
  SharedValues shared_;
};

} // namespace ndframe
