#pragma once

#include <cstdint>
#include <vector>

#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/sampling/sampled_basis.hpp"

namespace ndframe
{

/// A load in cells that follow each other, as in LoadProjection.
class ProjectedCells
{
public:
  ProjectedCells(int dim, int cells); ///< so many will be added

  /// The next cell. Where samples are not certain nothing is kept any more.
  void add(const LoadedSimplex& cell);
  bool areCertain() const { return areCertain_; } ///< samples were, in all cells
  std::size_t size() const { return cells_.size(); }
  /// The projection in a cell by the order of the calls of add(), and what Samples say of it.
  void fill(std::size_t number, LoadedSimplex& cell) const;

private:
  struct Cell
  {
    double scale, uncertainty, spread, rest; ///< as in Samples
  };

  std::size_t dim_;
  SampledBasis basis_;
  std::size_t low_; ///< functions of it of degree <= 2: rules give norms with these only
  bool areCertain_ = true;
  std::vector<Cell> cells_;
  std::vector<double> coefficients_; ///< cell by cell, as in LoadedSimplex
  std::vector<double> rows_;         ///< samples of the last cell by component
};

/// A load in the cells of a mesh as what the certificate needs of it: per cell its L2 projection on polynomials of
/// degree 5 - dim, whose moments the load's samples have right, and its distance from the projection. 190 bytes a
/// triangle.
class LoadProjection
{
public:
  /// Of all its cells, in the order of visitLoad; the parts are of equal size, the last one may be smaller.
  LoadProjection(const Mesh& mesh, std::vector<ProjectedCells> parts);

  /// Samples were certain in all cells, so that these may be kept.
  static bool areCertain(const std::vector<ProjectedCells>& parts);
  /// It was made on this mesh.
  bool isOf(const Mesh& mesh) const { return stamp_ == stampOf(mesh); }
  /// The projection in a cell by its number among them, and what Samples say of it.
  void fill(std::size_t number, LoadedSimplex& cell) const;

private:
  static std::uint64_t stampOf(const Mesh& mesh);

  std::uint64_t stamp_; ///< tells meshes apart
  std::vector<ProjectedCells> parts_;
};

} // namespace ndframe
