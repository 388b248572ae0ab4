#pragma once

#include <utility>
#include <vector>

#include "ndframe/equilibrium/body_piece.hpp"
#include "ndframe/equilibrium/cell_classes.hpp"
#include "ndframe/equilibrium/star_body.hpp"

namespace ndframe
{

/// The cells of all bodies whose tractions change together, numbered one body after the other: all of them, or those
/// that this rank holds.
class StressCells
{
public:
  /// bodies: those of a scene, null for the others. They must outlive this.
  explicit StressCells(std::vector<const StarBody*> bodies);
  /// pieces: of the bodies, which are pieces; they must outlive this, too. Collective.
  StressCells(std::vector<const StarBody*> bodies, const std::vector<const BodyPiece*>& pieces, const Comm& comm);

  int size() const { return first_.back(); }
  int numBodies() const { return int(bodies_.size()); }
  bool has(int body) const { return bodies_[std::size_t(body)] != nullptr; }
  const StarBody& body(int number) const { return *bodies_[std::size_t(number)]; }
  /// What all bodies share: dimension, degrees, bases.
  const StarBody& any() const { return *any_; }
  int facetData() const { return any_->facetData(); }

  /// The number of a body's cell.
  int number(int body, int cell) const { return first_[std::size_t(body)] + cell; }
  int bodyOf(int number) const;
  const Mesh& mesh(int number) const { return body(bodyOf(number)).model().mesh; }
  SortedCell sorted(int number) const;
  /// Of all cells, by their numbers.
  const CellClasses& classes() const { return classes_; }

  int rank() const { return rank_; }
  /// The rank that owns a cell.
  int owner(int number) const { return owner_.empty() ? rank_ : owner_[std::size_t(number)]; }
  bool isOwn(int number) const { return owner(number) == rank_; }

private:
  void count();

  std::vector<const StarBody*> bodies_;
  const StarBody* any_ = nullptr;
  std::vector<int> first_{0}; ///< per body, and the end
  CellClasses classes_;
  int rank_ = 0;
  std::vector<int> owner_; ///< per cell; empty: all are own
};

} // namespace ndframe
