#pragma once

#include <vector>

#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// The cells of a mesh, or some of them, joined across their facets (half facets: facet_twins.hpp) into a tree per
/// connected part.
class CellTree
{
public:
  /// Cells of a part, breadth first from its largest cell, and for each the half facet that leads to the cell before it
  /// on the way to the root (-1 for the root).
  struct Part
  {
    std::vector<int> cells, towardsRoot;
  };

  /// isIn: per cell, zero for those that belong to no part; empty: all do.
  explicit CellTree(const Mesh& mesh, std::vector<char> isIn = {});

  const SortedCell& cell(int cell) const { return cells_[std::size_t(cell)]; }
  int twin(int half) const { return twin_[std::size_t(half)]; } ///< -1 on the boundary
  const std::vector<Part>& parts() const { return parts_; }

  /// The part of a cell with that cell for its root.
  Part treeFrom(int root) const;

private:
  std::vector<SortedCell> cells_;
  std::vector<int> twin_;
  std::vector<char> isIn_;
  std::vector<Part> parts_;
};

} // namespace ndframe
