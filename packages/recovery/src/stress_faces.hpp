#pragma once

#include <array>
#include <vector>

#include "ndframe/equilibrium/star_wrench.hpp"
#include "star_body.hpp"

namespace ndframe
{

/// Force and moment over a length, about a point.
using Wrench = std::array<double, 6>;

/// A facet of a solid's cells, and the tractions that may be changed on it: T = own y + carrier r. `own` carries no
/// wrench; `carrier` carries the wrench  reach r  about the centre. Inside all tractions may change (reach = 1), on the
/// boundary those along supported directions.
struct StressFace
{
  std::array<int, 2> cell{-1, -1};  ///< the second is -1 on the boundary
  std::array<int, 2> facet{-1, -1}; ///< its sorted number in each cell; T acts on the first, -T on the second
  Direction centre{};
  double size = 0.0;               ///< square root of the area: moments are divided by it
  std::array<Direction, 2> arms{}; ///< means of (x - centre) L_1, (x - centre) L_2
  DenseMatrix own;                 ///< facet data x columns
  DenseMatrix carrier;             ///< facet data x r
  DenseMatrix reach;               ///< 6 x r, independent columns
  DenseMatrix choose;              ///< r x 6: the pseudo-inverse of reach

  bool isInside() const { return cell[1] >= 0; }
  /// The wrench of tractions T about a point, moments over `length`.
  Wrench wrench(const double* T, const double* point, double length) const;
};

/// An edge around which wrenches may circulate: from cell to cell through the facets that meet there.
struct StressEdge
{
  struct Step
  {
    int face;
    double sign;           ///< of the traction on the face's first cell
    int cell;              ///< the one that the step leaves
    DenseMatrix through{}; ///< amounts of the face's carrier, sign included: its columns x unknowns of the edge
  };
  std::vector<Step> ring; ///< closed inside; at supported boundaries from one facet there to another
  bool isClosed = true;
  Direction middle{};
  double length = 0.0;
  DenseMatrix basis; ///< 6 x unknowns: the wrenches that may circulate, about the middle
};

/// (F, M / from.length) about one point as (F, M' / to.length) about another.
Wrench movedWrench(const Wrench& wrench, const Direction& from, double fromLength, const Direction& to,
                   double toLength);

/// All faces and edges of a solid.
class StressFaces
{
public:
  explicit StressFaces(const StarBody& body);

  const std::vector<StressFace>& faces() const { return faces_; }
  const std::vector<StressEdge>& edges() const { return edges_; }
  /// The face of a cell's sorted facet.
  int faceOf(int cell, int facet) const { return faceOf_[std::size_t(cell) * 4 + std::size_t(facet)]; }

private:
  void addFaces();
  Vector findGeometry(StressFace& face) const;
  void freeTractions(StressFace& face, const Vector& arms) const;
  void freeReactions(StressFace& face, const Vector& arms) const;
  void addEdges();
  void addRing(const std::array<int, 2>& vertices, const std::vector<int>& around);
  DenseMatrix circulating(const StressEdge& edge) const;
  DenseMatrix through(const StressEdge& edge, const StressEdge::Step& step) const;

  const StarBody* body_;
  std::vector<StressFace> faces_;
  std::vector<StressEdge> edges_;
  std::vector<int> faceOf_;
};

} // namespace ndframe
