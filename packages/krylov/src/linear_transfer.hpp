#pragma once

#include <array>
#include <memory>

#include "fine_level.hpp"
#include "ndframe/iterative/linear_level.hpp"
#include "tpetra_maps.hpp"

namespace ndframe
{

/// P and P^T between the interior dofs of a body and those of its vertices, as this rank's nodes need them. Vectors are
/// zero elsewhere.
class LinearTransfer final : public FineTransfer
{
public:
  LinearTransfer(const RankProblem& fine, const LinearLevel& level, Teuchos::RCP<const TpetraMap> coarseMap);

  void toCoarse(const double* fine, TpetraVectors& coarse) override;
  void toFine(TpetraVectors& coarse, double* fine) override;
  Traffic traffic() const override { return halo_->traffic(); }
  const Teuchos::RCP<const TpetraMap>& coarseMap() const { return coarseMap_; }
  std::size_t fineSize() const { return ends_.size() * std::size_t(dim_); } ///< dofs of this rank

private:
  void annul(TpetraVectors& coarse) const;
  template <class Action>
  void eachEnd(const Action& action) const;

  int dim_;
  Teuchos::RCP<const TpetraMap> coarseMap_;
  std::vector<std::array<int, 2>> ends_; ///< per own node, vertices as this rank numbers them
  std::vector<int> turned_;              ///< per own node its place in blocks_, -1: none; empty: none at all
  std::vector<double> blocks_;
  std::vector<std::size_t> held_, coarseHeld_; ///< own dofs that are not interior
  std::unique_ptr<Halo> halo_;
  Teuchos::RCP<TpetraVectors> seen_; ///< of the vertices that this rank needs
};

} // namespace ndframe
