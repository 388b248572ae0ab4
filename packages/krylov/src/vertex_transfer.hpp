#pragma once

#include "joined_transfer.hpp"

namespace ndframe
{

/// P = L E between unknowns at the vertices and those at the same vertices that follow other statuses: no coarser
/// level, but one whose preconditioner is at hand.
class VertexTransfer final : public FollowingTransfer
{
public:
  /// levels: of all bodies; kept: the places of kept dofs among those of this rank's vertices.
  VertexTransfer(const std::vector<const LinearLevel*>& levels, KeptPlaces kept);
  void follow(const std::vector<SparseRow>& unknowns) override;
  void followOnVertices(const std::vector<SparseRow>& kept) override;

  void toCoarse(const double* fine, TpetraVectors& coarse) override;
  void toFine(TpetraVectors& coarse, double* fine) override;
  Traffic traffic() const override;

private:
  void annul(double* values) const;

  std::vector<std::size_t> held_; ///< own dofs that are not interior
  std::size_t size_ = 0;          ///< number of own dofs
  KeptPlaces kept_;
  FollowingRows taken_;  ///< L
  FollowingRows spread_; ///< E
};

} // namespace ndframe
