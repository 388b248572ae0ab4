#pragma once

#include <cstdint>
#include <map>

#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/fem/moment_basis.hpp"

namespace ndframe
{

/// A load in the cells of a mesh as what the certificate needs of it: per cell its L2 projection on polynomials of
/// degree 5 - dim, whose moments the load's samples have right, and its distance from the projection. 230 bytes a
/// triangle.
class LoadProjection
{
public:
  explicit LoadProjection(const Mesh& mesh);

  /// The next cell, in the order of visitLoad. Where samples are not certain nothing is kept any more.
  void add(const LoadedSimplex& cell);
  /// It is one of a load on this mesh, in all cells that were visited.
  bool isOf(const Mesh& mesh) const { return isKept_ && stamp_ == stampOf(mesh); }
  /// Samples of the projection in a cell by the order of the calls of add(). Memory of `samples` is reused.
  void fill(std::size_t number, Samples& samples) const;

private:
  /// The basis at the points of a rule: times the weights, a row a point; by itself, a row a function; the weights.
  struct Tables
  {
    std::vector<double> weighted, values, weights;
  };
  struct Cell
  {
    double scale, uncertainty, spread, rest; ///< as in Samples
  };

  static std::uint64_t stampOf(const Mesh& mesh);
  Tables makeTables(const QuadratureRule& rule) const;
  const Tables& tablesOf(const Samples& samples);

  std::size_t dim_;
  MomentBasis basis_;
  std::size_t low_;     ///< functions of it of degree <= 2: rules give norms with these only
  std::uint64_t stamp_; ///< tells meshes apart
  bool isKept_ = true;
  const QuadratureRule& rule_; ///< of the samples of projections
  std::vector<double> atRule_; ///< the basis at its points, a row a function, padded
  std::vector<Cell> cells_;
  std::vector<double> values_; ///< at the rule's points, cell by cell, a row a component, padded
  std::map<const QuadratureRule*, Tables> known_;
  Tables many_;                                       ///< of the last cell that is not one piece
  std::vector<double> rows_, coefficients_, factors_; ///< of the last cell, by component and by function
};

} // namespace ndframe
