#pragma once

#include "ndframe/simd/stress_matrices.hpp"
#include "stress_edges.hpp"

namespace ndframe
{

/// What cells' matrices mean for the tractions of their faces and edges: X^T A X, X the columns that unknowns stand
/// for. Some cells side by side, up to CellForms::lanes; what is inside in their common steps, the rest cell by cell.
class CellBlocks
{
public:
  explicit CellBlocks(const StressFaces& faces); ///< faces must outlive it

  void compute(const CellFacets& matrices);

  /// Adds own^T A own of the face at a cell's facet, the lower triangle column by column.
  void addFace(int lane, int facet, double* sum) const;
  /// The same of what the cell has of an edge's block. inside: the facets there if all wrenches may circulate and both
  /// take them as they are, else -1.
  using Pair = std::array<int, 2>;
  void addEdge(int lane, const StressEdge& edge, Pair inside, double* sum) const;

private:
  static constexpr std::ptrdiff_t lanes = CellForms::lanes, mostRows = 18, linear = CellForms::linear, mostOwn = 12,
                                  wrench = 6;

  /// Where faces are, per number and lane.
  struct Shapes
  {
    double centre[3 * lanes], size[lanes], arms[6 * lanes];
    double carrier[18 * lanes]; ///< linear tractions (6) by moments (3), row by row
  };

  void findShapes(const CellFacets& matrices);
  void putShape(std::ptrdiff_t lane, std::size_t facet, const StressFace& face);
  void findEdge(std::ptrdiff_t first, std::ptrdiff_t second);
  double alone(int lane, int facet, std::ptrdiff_t i, std::ptrdiff_t j) const
  {
    return *(alone_.data() + ((facet * mostRows + j) * mostRows + i) * lanes + lane);
  }
  double between(int lane, std::array<int, 2> facets, std::ptrdiff_t i, std::ptrdiff_t j) const;

  const StressFaces* faces_;
  int facetData_;
  std::array<int, std::size_t(lanes)> cells_{};
  Vector alone_;                 ///< per facet A in global axes, mostRows x mostRows
  Vector pairs_;                 ///< per pair of facets A of linear tractions, in global axes
  Vector own_;                   ///< per facet what faces inside have, mostOwn x mostOwn
  Vector carriers_;              ///< per two facets, the second not before the first, wrench x wrench
  Vector edges_;                 ///< per pair of facets what edges inside have, wrench x wrench
  std::array<Shapes, 4> shapes_; ///< per facet
  double points_[12 * lanes]{};  ///< sorted vertices
};

} // namespace ndframe
