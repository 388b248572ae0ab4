#pragma once

#include <optional>

#include "fine_level.hpp"
#include "tpetra_maps.hpp"

namespace ndframe
{

/// K of a body on its interior dofs, in the blocks in which it was assembled: no copy of it.
class BlockOperator final : public FineOperator
{
public:
  BlockOperator(const RankProblem& problem, const Comm& comm);

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return dofMap_; }
  void multiply(const TpetraVectors& x, double* y) const override;
  /// y = |K| |x|, the moduli of the entries, in all rows.
  void sizes(const TpetraVectors& x, double* y) const;
  std::vector<double> inverseDiagonal() const override;
  std::vector<std::int64_t> numbers() const override;
  int products() const override { return products_; }
  Traffic traffic() const override { return halo_ ? halo_->traffic() : Traffic(); }

private:
  /// x with the values of other ranks that the rows need.
  Teuchos::ArrayRCP<const double> seen(const TpetraVectors& x) const;

  const BlockMatrix& matrix_;
  Teuchos::RCP<const TpetraMap> dofMap_;
  std::vector<char> interior_; ///< per dof of this rank
  std::optional<Halo> halo_;
  Teuchos::RCP<TpetraVectors> seen_; ///< null on one rank
  mutable int products_ = 0;
};

} // namespace ndframe
