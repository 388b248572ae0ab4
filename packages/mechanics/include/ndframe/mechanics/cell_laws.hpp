#pragma once

#include <vector>

#include "ndframe/mechanics/elasticity.hpp"

namespace ndframe
{

/// The law of every cell of a body: one for all of them, or several.
class CellLaws
{
public:
  CellLaws() = default;
  /// One law for all cells.
  CellLaws(const Elasticity& law) : laws_{law} {} // NOLINT: a body of one material is what most bodies are

  /// laws[ofCell[c]] in cell c. Laws that are equal become one, so that a body whose parts are made of one material is
  /// computed as if it had no parts; laws that no cell has stay, so that parts of a body number them as the whole does.
  CellLaws(const std::vector<Elasticity>& laws, const std::vector<int>& ofCell);

  const Elasticity& operator()(int cell) const { return laws_[std::size_t(number(cell))]; } ///< of this cell
  /// Which of all() is the law of a cell.
  int number(int cell) const { return ofCell_.empty() ? 0 : ofCell_[std::size_t(cell)]; }
  int numberOf(const Elasticity& law) const; ///< of one of all()
  /// Those that differ.
  const std::vector<Elasticity>& all() const { return laws_; }
  bool isUniform() const { return laws_.size() == 1; } ///< all cells have one law

private:
  std::vector<Elasticity> laws_{1};
  std::vector<int> ofCell_; ///< empty: the first for all
};

} // namespace ndframe
