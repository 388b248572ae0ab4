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
    int face;
    double sign;           ///< of the traction on the face's first cell
    int cell;              ///< the one that the step leaves
    DenseMatrix through{}; ///< amounts of the face's carrier, sign included: its columns x unknowns of the edge; empty
                           ///< where all wrenches may circulate and the face takes them all
  };
  std::vector<Step> ring; ///< closed inside; at supported boundaries from one facet there to another
  Direction middle{};
  double length = 0.0;
  DenseMatrix basis; ///< 6 x unknowns: the wrenches that may circulate, about the middle
};

/// StressEdge::Step::through whether it is empty or not.
struct ThroughMatrix
{
  ThroughMatrix() = default;
  ThroughMatrix(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face);

  double operator()(int i, int j) const { return values[std::size_t(i) + 6 * std::size_t(j)]; }

  int rows = 0, cols = 0;
  std::array<double, 36> values{}; ///< 6 x 6 at most
};

/// amounts += through z of a step.
void addThrough(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face, const double* z,
                double* amounts);

/// sum += through^T forces of a step, forces on the face's amounts.
void addBack(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face, const double* forces,
             double* sum);

/// Per face the steps of rings that go through it, edges ascending.
class FaceRings
{
public:
  struct Place
  {
    int edge, step;
  };

  FaceRings(int faces, const std::vector<StressEdge>& edges);

  const Place* begin(int face) const { return places_.data() + first_[std::size_t(face)]; }
  const Place* end(int face) const { return places_.data() + first_[std::size_t(face) + 1]; }

private:
  std::vector<std::size_t> first_; ///< per face, and the end
  std::vector<Place> places_;
};

/// All edges around which anything can circulate. Those at which a body touches itself are left out.
std::vector<StressEdge> stressEdges(const StressFaces& faces);

} // namespace ndframe
