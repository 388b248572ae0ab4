#pragma once

#include <cstdint>
#include <vector>

#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/assembly/sampled_basis.hpp"

namespace ndframe
{

/// A load in the cells of a mesh as what the certificate needs of it: per cell its L2 projection on polynomials of
/// degree 5 - dim, whose moments the load's samples have right, and its distance from the projection. 190 bytes a
/// triangle.
class LoadProjection
{
public:
  explicit LoadProjection(const Mesh& mesh);

  /// The next cell, in the order of visitLoad. Where samples are not certain nothing is kept any more.
  void add(const LoadedSimplex& cell);
  bool isKept() const { return isKept_; } ///< samples were certain in all cells
  /// It was made on this mesh.
  bool isOf(const Mesh& mesh) const { return stamp_ == stampOf(mesh); }
  /// The projection in a cell by the order of the calls of add(), and what Samples say of it.
  void fill(std::size_t number, LoadedSimplex& cell) const;

private:
  struct Cell
  {
    double scale, uncertainty, spread, rest; ///< as in Samples
  };

  static std::uint64_t stampOf(const Mesh& mesh);

  std::size_t dim_;
  SampledBasis basis_;
  std::size_t low_;     ///< functions of it of degree <= 2: rules give norms with these only
  std::uint64_t stamp_; ///< tells meshes apart
  bool isKept_ = true;
  std::vector<Cell> cells_;
  std::vector<double> coefficients_; ///< cell by cell, as in LoadedSimplex
  std::vector<double> rows_;         ///< samples of the last cell by component
};

} // namespace ndframe
