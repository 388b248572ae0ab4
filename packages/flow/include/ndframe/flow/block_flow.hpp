#pragma once

#include <memory>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/equilibrium/body_piece.hpp"
#include "ndframe/flow/wrench_flow.hpp"

namespace ndframe
{

/// Hands on what the cells of a body lack of balance from cell to cell, in two steps: between boxes of some hundred
/// cells, where what hangs together in a box is one node of a WrenchFlow that all ranks make, then between the cells of
/// each box, by the ranks that have cells of it. Boxes depend on the body alone, so the flow does not depend on how the
/// ranks share the cells, but for round-off; no rank has all cells.
class BlockFlow
{
public:
  /// held: the cells of this rank and those around them; piece: what they are of the body, null where they are all of
  /// it. Collective.
  BlockFlow(const Mesh& held, const BodyPiece* piece, const Comm& comm);

  const Direction& centre(int cell) const { return centres_[std::size_t(cell)]; } ///< of a held one
  int numParts() const { return between_->numParts(); } ///< of the body, that hang together through faces
  int partOf(int cell) const { return between_->partOf(setOf_[std::size_t(cell)]); }

  /// lacks: per held cell, about its centre, zero at ghosts; a part's add up to nothing. Per half facet (facetTwins) of
  /// the held mesh what tractions there are to add to it, about the facet's centre; zero on the boundary and at ghosts.
  /// What parts lack in all stays in some cell; round-off does in others. Collective.
  std::vector<ForceMoment> through(const std::vector<ForceMoment>& lacks) const;

  class Builder;

private:
  /// A face between two boxes.
  struct Crossing
  {
    int link;                ///< of between_
    double sign;             ///< +1: its first cell is in the link's first node
    std::array<int, 2> near; ///< its cells, -1: in no box of this rank
    Spring spring;
  };
  /// Where the flow at a half facet is found: a link of within_ or a crossing, whose first cell has it or gives it.
  struct Place
  {
    int half, number;
    bool isCrossing;
    double sign;
  };

  void cross(const std::vector<ForceMoment>& betweenSets, std::vector<ForceMoment>& lacks,
             std::vector<ForceMoment>& crossed) const;

  Comm comm_;
  std::vector<Direction> centres_;      ///< per held cell
  std::vector<int> own_, nearOf_;       ///< own cells, and which of the near ones they are
  std::vector<int> setOf_;              ///< per held cell: its node of between_
  SharedValues shared_;                 ///< of near cells: those in the boxes of own cells, by their numbers
  std::unique_ptr<WrenchFlow> within_;  ///< of near cells
  std::unique_ptr<WrenchFlow> between_; ///< the same on all ranks
  std::vector<Crossing> crossings_;     ///< of near cells
  std::vector<Place> places_;           ///< of own cells
  std::size_t halves_ = 0;
};

} // namespace ndframe
