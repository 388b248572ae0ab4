#pragma once

#include <vector>

#include "ndframe/algebra/field.hpp"
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

  /// What the part's nodes or cells are of the body's.
  struct Things
  {
    Global all;                  ///< of the whole body
    std::vector<Global> numbers; ///< per node or cell of the part that of the whole body
    std::vector<int> owners;     ///< per node or cell of the part, the rank
  };

  /// nodes: by ascending numbers; cells: the first ones are the rank's own. Collective.
  BodyShare(Things nodes, Things cells, const Comm& comm);

  Global numNodes() const { return nodes_.all; } ///< of the whole body
  Global numCells() const { return cells_.all; } ///< of the whole body
  int numOwnCells() const { return numOwnCells_; }
  bool owns(int node) const { return nodes_.owners[std::size_t(node)] == rank_; }
  const std::vector<Global>& numbers() const { return nodes_.numbers; } ///< per node of the part
  const std::vector<int>& owners() const { return nodes_.owners; }      ///< the same
  const Things& cells() const { return cells_; }
  std::vector<int> ownNodes() const; ///< of the part, ascending
  /// Values of nodes of the part, `width` for each, become those of their owners. Collective among neighbours.
  void fetch(Vector& values, int width) const;
  /// Values at other ranks' nodes become zero.
  void annulOthers(Vector& values, int width) const;
  /// Values at own nodes, ascending, from those of the part, and back with zeros elsewhere.
  Vector own(const Vector& values, int width) const;
  /// The same as a field on what is owned of the body's nodes, which `nodes` has in the same order.
  NodalField own(const Vector& values, int width, const IndexMap& nodes) const
  {
    return {nodes.withoutGhosts(), width, own(values, width)};
  }
  Vector spread(const Vector& own, int width) const; ///< fetches the other ranks' values. Collective

private:
  Things nodes_, cells_;
  int rank_, numOwnCells_;
  SharedValues shared_;
};

} // namespace ndframe
