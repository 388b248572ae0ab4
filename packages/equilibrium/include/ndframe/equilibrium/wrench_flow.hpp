#pragma once

#include <array>
#include <vector>

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Force and moment.
using ForceMoment = std::array<double, 6>;

/// Hands on what the cells of a body lack of balance from cell to cell until every cell has what it needs.
///
/// Cells are halved by place again and again, and what a half lacks comes from the other one through all faces between
/// the two: as a rigid motion of one against the other with springs on the faces would carry it. So what passes through
/// a face is what a compact set of cells lacks, not a path of them, and levers are as long as the set is. Any flow is
/// admissible; this one is near that of the least energy where what neighbours lack nearly adds up to nothing.
/// Which cells are halves depends on the mesh alone.
class WrenchFlow
{
public:
  /// A face inside, between the two cells of half facets (facetTwins).
  struct Face
  {
    std::array<int, 2> half; ///< the smaller one first
    Direction centre;
    double size;        ///< square root of the area
    double conductance; ///< the area squared over the volumes beside it
  };

  explicit WrenchFlow(const Mesh& mesh);

  const std::vector<Face>& faces() const { return faces_; }
  /// The number of the face at a half facet; -1 on the boundary.
  int faceOf(int half) const { return faceOf_[std::size_t(half)]; }
  const Direction& centre(int cell) const { return centres_[std::size_t(cell)]; }
  int numParts() const { return int(parts_.size()); } ///< that hang together through faces
  int partOf(int cell) const { return partOf_[std::size_t(cell)]; }
  /// lacks: per cell, about its centre; a part's add up to nothing. What tractions on the first cell of every face are
  /// to add, about the face's centre. What parts lack in all stays in one of their cells; round-off does in others.
  std::vector<ForceMoment> through(std::vector<ForceMoment> lacks) const;

private:
  struct Range
  {
    int first, last;
  };
  class Pass;

  std::vector<Face> faces_;
  std::vector<int> faceOf_;
  std::vector<Direction> centres_;
  std::vector<std::vector<int>> parts_;
  std::vector<int> partOf_;
};

/// sum += a wrench about one point as one about another.
void addMoved(const ForceMoment& wrench, const Direction& from, const Direction& to, ForceMoment& sum);

} // namespace ndframe
