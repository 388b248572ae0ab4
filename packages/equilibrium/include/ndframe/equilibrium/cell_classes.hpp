#pragma once

#include "ndframe/assembly/body_system.hpp"

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

  /// The classes of some cells alone, in this order, numbered as here but without those that none of them has. count()
  /// stays that of all cells, and so does origin(); first() is one of these cells.
  CellClasses among(const std::vector<int>& cells) const;

  int size() const { return int(first_.size()); }
  int of(int cell) const { return of_[std::size_t(cell)]; }
  /// The first cell of a class.
  int first(int number) const { return first_[std::size_t(number)]; }
  /// The first cell of a class among all cells, by its number there: whatever is made from it is the same on all ranks.
  int origin(int number) const { return origin_.empty() ? first(number) : origin_[std::size_t(number)]; }
  bool hasOrigin(int number) const
  {
    return hasOrigin_.empty() || hasOrigin_[std::size_t(number)] != 0;
  } ///< it is first()
  /// How many cells it has.
  int count(int number) const { return count_[std::size_t(number)]; }
  double scale(int cell) const { return length_[std::size_t(first(of(cell)))] / length_[std::size_t(cell)]; }

private:
  CellClasses() = default;

  std::vector<int> of_, first_, count_, origin_; ///< the last one empty where it is first_
  std::vector<char> hasOrigin_;                  ///< empty: all have
  Vector length_;                                ///< of every cell
};

} // namespace ndframe
