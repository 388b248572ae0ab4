#pragma once

#include "block_operator.hpp"
#include "kept_rows.hpp"

namespace ndframe
{

/// E^T K E + springs of several bodies, one after another, whose kept dofs follow unknowns (JoinedUnknowns).
class JoinedOperator final : public FineOperator
{
public:
  /// nodes: of all bodies, stacked.
  JoinedOperator(const std::vector<const RankProblem*>& bodies, const IndexMap& nodes,
                 const std::vector<RankProblem::Global>& kept, const Comm& comm);
  void follow(const JoinedUnknowns& unknowns); ///< collective
  /// y = K x as if nothing joined the bodies.
  void multiplyBodies(const double* x, double* y) const;
  void sizesOfBodies(const double* x, double* y) const; ///< the same of moduli, in all rows

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return dofMap_; }
  void multiply(const TpetraVectors& x, double* y) const override;
  std::vector<double> inverseDiagonal() const override;
  std::vector<std::int64_t> numbers() const override;
  int products() const override { return parts_.front()->products(); }
  Traffic traffic() const override;

private:
  /// take(body, its part of x, of y)
  template <class Take>
  void eachBody(const double* x, double* y, const Take& take) const;

  std::vector<Teuchos::RCP<BlockOperator>> parts_;
  std::vector<std::int64_t> firstNumbers_;         ///< per body
  std::vector<Teuchos::RCP<TpetraVectors>> moved_; ///< E x, per body
  Teuchos::RCP<const TpetraMap> dofMap_;
  KeptPlaces kept_;
  FollowingRows spread_;                   ///< E
  std::vector<double> diagonal_, springs_; ///< per own kept dof, the latter empty: none
  mutable std::vector<double> work_;
};

} // namespace ndframe
