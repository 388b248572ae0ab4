#pragma once

#include <cstdint>

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
  /// Whether the cell of a class that comes first among those of all ranks is this rank's own.
  bool hasOrigin(int number) const { return hasOrigin_[std::size_t(number)] != 0; }
  double scale(int cell) const { return length_[std::size_t(first(of(cell)))] / length_[std::size_t(cell)]; }

private:
  /// Returns per class a hash that is the same on all ranks.
  std::vector<std::int64_t> find(const std::vector<const BodyModel*>& bodies);
  void agree(const std::vector<const BodyPiece*>& pieces, const std::vector<std::int64_t>& hashes, const Comm& comm);

  std::vector<int> of_, first_, count_;
  Vector length_;               ///< of every cell
  std::vector<char> hasOrigin_; ///< per class
};

} // namespace ndframe
