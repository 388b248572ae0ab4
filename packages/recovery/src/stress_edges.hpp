#pragma once

#include "stress_faces.hpp"

namespace ndframe
{

/// An edge around which wrenches may circulate: from cell to cell through the faces that meet there, also from one body
/// into another through faces in contact.
struct StressEdge
{
  struct Step
  {
    int face, cell; ///< the cell that the step leaves
    double sign;    ///< of the traction on the face's first cell
    /// Amounts of the face's carrier, sign included: its columns x unknowns of the edge; null where all wrenches may
    /// circulate and the face takes them all.
    std::unique_ptr<const DenseMatrix> through{};
  };
  std::vector<Step> ring; ///< closed inside; at supported boundaries from one facet there to another
  Direction middle{};
  double length = 0.0;
  int unknowns = 0; ///< the wrenches that may circulate: six, or those that all faces of the ring can take
};

/// StressEdge::Step::through whether it is there or not.
struct ThroughMatrix
{
  ThroughMatrix() = default;
  ThroughMatrix(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face);

  double operator()(int i, int j) const { return values[std::size_t(i) + 6 * std::size_t(j)]; }

  int rows = 0, cols = 0;
  std::array<double, 36> values{}; ///< 6 x 6 at most
};

/// The columns that an edge's unknowns stand for on a face of its ring, as the cell of one side feels them.
DenseMatrix edgeColumns(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face, std::size_t side);

/// The same on each facet of a cell, as the cell feels them; none where the ring does not pass.
std::array<DenseMatrix, 4> edgeColumns(const StressEdge& edge, const StressFaces& faces, int cell);

/// All edges of own cells around which anything can circulate, whole rings. Those at which a body touches itself are
/// left out.
std::vector<StressEdge> stressEdges(const StressFaces& faces);

} // namespace ndframe
