#pragma once

#include <memory>
#include <optional>
#include <unordered_map>

#include "box_bounds.hpp"
#include "chebyshev_box.hpp"

namespace ndframe
{

/// Polynomials of one expression on a tree of boxes, made when they are asked for: the expression is interpolated on
/// the largest boxes where that shows it to be a polynomial, smaller boxes inside have theirs from the next larger one,
/// and a cell has that of the largest box around it where a low degree is enough, or one of its own.
class BoxPolynomials
{
public:
  /// space: the number of coordinates, 2 or 3.
  BoxPolynomials(const ExpressionTree& tree, int space) : tree_(tree), space_(space) {}

  /// What follows depends on no cell before; isSame: what is allowed will be the same as before.
  void begin(bool isSame);
  /// The one on a box that holds a simplex; null if none is shown to be right to `allowed`.
  const BoxPolynomial* around(const Region::Point& centroid, double radius, double allowed);
  /// Boxes on which the expression was interpolated.
  int fitted() const { return fitted_; }

private:
  static constexpr int largest = 9; ///< logarithm of the width of boxes, in radii of cells

  struct Place
  {
    TreeBox::Place box;
    int up = 0; ///< logarithm of the width in radii: how far a box reaches beyond its cell of the tree depends on it
    bool operator==(const Place& other) const { return up == other.up && box == other.box; }
  };
  struct Hash
  {
    std::size_t operator()(const Place& place) const;
  };
  struct Box
  {
    std::unique_ptr<const ChebyshevBox> series;    ///< null if none is shown, or cells and boxes inside do not need it
    std::unique_ptr<const BoxPolynomial> inPowers; ///< null but on the largest boxes of low degree
    const BoxPolynomial* ofCells = nullptr;        ///< that of the largest such box around this one, if there is one
  };

  Box& boxAround(const Region::Point& centroid, int level, int up, double allowed);
  const BoxPolynomial* ofCell(const Region::Point& centroid, double radius, double allowed);
  void make(Box& box, const TreeBox& place, int level, int up, double allowed);

  const ExpressionTree& tree_;
  int space_;
  std::unordered_map<Place, Box, Hash> boxes_;
  int lastUp_ = largest;                ///< where the last one was found
  const BoxPolynomial* last_ = nullptr; ///< neighbours follow each other
  std::optional<BoxPolynomial> cell_;   ///< of one simplex, where the smallest box is too large
  int fitted_ = 0;
};

} // namespace ndframe
