#pragma once

#include <optional>
#include <vector>

#include "box_bounds.hpp"
#include "simplex_piece.hpp"

namespace ndframe
{

/// Where one of several functions switches: an operation of its tree.
struct DataSwitch
{
  std::size_t function = 0;
  int place = -1;
};

/// What functions are on the two sides of a switch.
struct SwitchedEnclosures
{
  std::vector<Enclosure> sides; ///< one a function and side
  double jump = 0.0;            ///< a bound of the difference between two values on the region, whatever the side
};

/// The enclosures of several functions on simplices and their pieces.
class DataEnclosures
{
public:
  DataEnclosures(const std::vector<SampledFunction>& functions, int space);

  bool arePolynomials() const;
  /// One enclosure a function between corners: from the tree of boxes where a whole simplex is small enough for it to
  /// show that some rule misses at most `enough`, otherwise of the region itself. dim: of the simplex.
  std::vector<Enclosure> on(int dim, const std::vector<Region::Point>& corners, bool isWhole, double enough);
  /// An upper bound of the functions' absolute values on a simplex, by the tree of boxes.
  double largestAround(const SimplexGeometry& simplex);
  /// The same between corners, by the region itself.
  double largestBetween(const std::vector<Region::Point>& corners) const;
  /// The same on both sides of a switch, of this or of other functions that switch with it.
  SwitchedEnclosures onSides(const std::vector<Region::Point>& corners, DataSwitch at) const;
  /// The function that changes its sign at a switch.
  ExpressionTree part(DataSwitch at) const { return trees_[at.function]->part(at.place); }
  /// Where to cut a region on which a function misses polynomials by `error`: the affine function in it that explains
  /// most of this alone, less its value in the middle. Nothing when none explains a tenth.
  std::optional<AffineFunction> steepest(int dim, const std::vector<Region::Point>& corners, std::size_t function,
                                         double error) const;

private:
  std::vector<const ExpressionTree*> trees_;
  std::vector<BoxBounds> boxes_;
};

} // namespace ndframe
