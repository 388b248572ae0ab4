#pragma once

#include "batched_star_data.hpp"
#include "batched_workspace.hpp"

namespace ndframe
{

/// Numbers per cell and field that sweeps start from (StarBatch::total): tractions of two spokes, loads, tractions of
/// the rim.
constexpr int totalsPerCell(int degree)
{
  return 6 * (degree + 1) + 2 * loadModesOf(degree);
}

/// A facet of a star's cell, by its number in sorted order.
struct CornerFacet
{
  int number;
  /// Of even and odd modes: odd L_k change their sign where the sorted vertices run against the star's order.
  const double* signs;

  double sign(int mode) const { return signs[mode & 1]; }
};

struct CornerFacets
{
  CornerFacet first, second, rim;
};

/// Without branches: orders are by chance and could not be predicted.
inline CornerFacets facetsOf(const Rings& rings, int corner)
{
  static constexpr double signs[2][2] = {{1.0, 1.0}, {1.0, -1.0}};
  const int rank = rings.rank(corner), next = rings.rank(Rings::next(corner)), last = 3 - rank - next;
  return {{last, signs[rank > next]}, {next, signs[rank > last]}, {rank, signs[next > last]}};
}

/// One pass over stars: gathers batches of equal valence, runs the kernels, adds the result to the corrections.
class BatchedPass
{
public:
  /// inputs: of the initial pass; null for sweeps.
  BatchedPass(const BatchedStarData& stars, const StarFieldInputs* inputs, int maxCells,
              std::vector<StressCorrection>& corrections);

  /// Vertices of one valence and kind, at most as many as there are lanes.
  void run(const int* vertices, int count);

private:
  void gatherSpokes();
  void gatherLaws();
  void gatherStress();
  void gatherBodyLoad();
  void gatherTotals();
  void closeFan(int lane);
  void scatter();
  void addLoads();
  void noteForces(int lane);
  /// The corner of the star's vertex in its cell number c.
  int corner(int lane, int c) const { return corners_[std::size_t(lane)][c]; }
  /// Of number `item` of a lane.
  std::ptrdiff_t place(int item, int lane) const { return std::ptrdiff_t(item) * lanes_ + lane; }

  const BatchedStarData& stars_;
  const StarFieldInputs* inputs_;
  std::vector<StressCorrection>& corrections_;
  int fields_, facetData_, lanes_;
  BatchWorkspace workspace_;
  StarBatch batch_;
  int count_ = 0;                   ///< lanes in use; the others repeat the first star
  std::vector<const int*> corners_; ///< per lane: Rings::corners
};

} // namespace ndframe
