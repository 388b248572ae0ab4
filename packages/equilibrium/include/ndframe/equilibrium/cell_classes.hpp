#pragma once

#include <unordered_map>

#include "ndframe/equilibrium/body_piece.hpp"

namespace ndframe
{

/// Which cells of solids differ by their places and sizes alone: vertices in sorted order, edge vectors proportional,
/// laws the same. Their energy matrices A_E are the same but for a factor, because T and G are forces:
///
///   A_E = scale(E) A_first,   scale = length of the first cell / length of E
///
/// Proportional means: to 2^-44 of the cell's longest coordinate difference. What round-off of coordinates far from the
/// origin moves by more than that is in classes of its own, which costs time only.
class CellClasses
{
public:
  /// Edge vectors from a cell's first vertex, in sorted order, over its longest coordinate difference.
  using Edges = std::array<double, 9>;

  /// bodies: null where there is none; cells are numbered one body after the other.
  explicit CellClasses(const std::vector<const BodyModel*>& bodies);
  /// Of the cells that this rank holds of bodies in pieces; pieces: null where there is no body. Collective.
  CellClasses(const std::vector<const BodyPiece*>& pieces, const Comm& comm);

  int size() const { return int(first_.size()); }
  int of(int cell) const { return of_[std::size_t(cell)]; }
  /// The first cell of a class.
  int first(int number) const { return first_[std::size_t(number)]; }
  /// How many cells it has, of all ranks.
  int count(int number) const { return count_[std::size_t(number)]; }
  /// Whether this rank has the cell of a class that comes first among those of all ranks.
  bool hasOrigin(int number) const { return origins_.count(number) == 0; }
  /// The edges of that cell: whatever is made from them is the same on all ranks. mesh: of first(), cell: its number
  /// there.
  Edges edges(int number, const Mesh& mesh, int cell) const;
  double scale(int cell) const { return length_[std::size_t(first(of(cell)))] / length_[std::size_t(cell)]; }

private:
  void find(const std::vector<const BodyModel*>& bodies);
  void agree(const std::vector<const BodyPiece*>& pieces, const Comm& comm);

  std::vector<int> of_, first_, count_;
  Vector length_;                          ///< of every cell
  std::vector<std::int64_t> hashes_;       ///< per class, while ranks agree
  std::unordered_map<int, Edges> origins_; ///< of classes whose first cells are other ranks'
};

} // namespace ndframe
