#pragma once

#include <vector>

#include "ndframe/base/expression_enclosure.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A simplex in space, and pieces of it by barycentric coordinates.
class SimplexGeometry
{
public:
  SimplexGeometry(int dim, int space, const DataSampler::Vertices& vertices);

  int dim() const { return dim_; }
  int space() const { return space_; }
  const DataSampler::Vertices& vertices() const { return vertices_; }
  Samples::Piece whole() const;
  /// Barycentric coordinates in the simplex of a point of a piece.
  void locate(const Samples::Piece& piece, const double* local, double* lambda) const;
  /// The point of space; coordinates that space does not have are zero, and those that all vertices share are kept to
  /// the last bit: data may switch there.
  Region::Point place(const double* lambda) const;
  /// The points of a rule on the whole simplex, three coordinates each.
  void place(const QuadratureRule& rule, double* points) const;
  std::vector<Region::Point> corners(const Samples::Piece& piece) const;
  Region::Point centroid() const;
  /// The centroid and the largest distance of a vertex from it along an axis.
  void extent(Region::Point& centroid, double& radius) const;

  /// The two halves of a piece at the middle of its longest edge.
  std::vector<Samples::Piece> bisect(const Samples::Piece& piece) const;
  /// Pieces on which f has one sign. Corners with values that are round-off of f's terms lie on f = 0; a piece where f
  /// does not change its sign comes back as it is.
  std::vector<Samples::Piece> cut(const Samples::Piece& piece, const AffineFunction& f) const;

private:
  Samples::Piece replaced(const Samples::Piece& piece, int corner, int other, double share) const;

  int dim_, space_;
  DataSampler::Vertices vertices_;
  std::array<bool, 3> isShared_{}; ///< per coordinate
};

} // namespace ndframe
