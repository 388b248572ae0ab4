#pragma once

#include <optional>
#include <vector>

#include "simplex_piece.hpp"

namespace ndframe
{

/// The part of a piece of a simplex between two values of an affine function, as pieces. Slabs are cut from the piece
/// that they began with, so that the number of their pieces does not grow when they become thinner.
class SampledSlab
{
public:
  explicit SampledSlab(const Samples::Piece& piece) : base_(piece), parts_{piece} {}

  const std::vector<Samples::Piece>& parts() const { return parts_; }
  double fraction() const;
  std::vector<Region::Point> corners(const SimplexGeometry& simplex) const;
  bool isWhole() const { return parts_.size() == 1 && parts_.front().fraction == 1.0; }

  /// The slabs on the two sides of f = 0; its pieces one by one where f is not parallel to the slab; nothing when f
  /// does not change its sign inside.
  std::vector<SampledSlab> cut(const SimplexGeometry& simplex, const AffineFunction& f) const;
  /// The halves of a piece, or the pieces of several one by one.
  std::vector<SampledSlab> bisect(const SimplexGeometry& simplex) const;

private:
  SampledSlab between(const SimplexGeometry& simplex, const AffineFunction& f, Interval range) const;
  std::vector<SampledSlab> single() const;

  Samples::Piece base_;
  std::vector<Samples::Piece> parts_;
  std::optional<AffineFunction> across_; ///< nothing: the whole base
  Interval range_;                       ///< of `across_`
};

} // namespace ndframe
