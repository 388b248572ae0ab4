#pragma once

#include "joined_operator.hpp"
#include "linear_transfer.hpp"

namespace ndframe
{

/// A transfer between unknowns that change and coarse ones that may follow other statuses.
class FollowingTransfer : public FineTransfer
{
public:
  virtual void follow(const std::vector<SparseRow>& unknowns) = 0;       ///< L. Collective
  virtual void followOnVertices(const std::vector<SparseRow>& kept) = 0; ///< E of the coarse unknowns. Collective
};

/// P = L P_bodies E between the unknowns of several bodies and those at their vertices, which may follow other
/// statuses: E there makes displacements of the coarse unknowns, L takes the fine unknowns from them.
class JoinedTransfer final : public FollowingTransfer
{
public:
  JoinedTransfer(std::vector<LinearTransfer> bodies, KeptPlaces kept, KeptPlaces coarseKept);
  void follow(const std::vector<SparseRow>& unknowns) override;
  void followOnVertices(const std::vector<SparseRow>& kept) override;

  void toCoarse(const double* fine, TpetraVectors& coarse) override;
  void toFine(TpetraVectors& coarse, double* fine) override;
  Traffic traffic() const override;

  void toVertices(const double* fine, double* vertices);   ///< P_bodies^T
  void fromVertices(const double* vertices, double* fine); ///< P_bodies

private:
  std::vector<LinearTransfer> bodies_;
  std::vector<Teuchos::RCP<TpetraVectors>> coarse_; ///< per body
  KeptPlaces kept_, coarseKept_;
  FollowingRows taken_;                 ///< L
  FollowingRows coarseSpread_;          ///< E
  std::vector<std::size_t> fineStarts_; ///< per body
  std::vector<double> work_;
};

} // namespace ndframe
