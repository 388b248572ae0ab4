#pragma once

#include <Teuchos_Comm.hpp>

#include "block_operator.hpp"
#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

/// Places of kept dofs among this rank's dofs, whose values all ranks need.
class KeptPlaces
{
public:
  /// kept: their numbers. dofMap: the dofs of this rank.
  KeptPlaces(const std::vector<int>& kept, const Teuchos::RCP<const TpetraMap>& dofMap);

  /// On all ranks.
  std::vector<double> gather(const double* x) const;
  void scatter(const std::vector<double>& kept, double* x) const;
  /// x's kept values become rows times them, or rows^T times them.
  void replace(const std::vector<SparseRow>& rows, double* x) const;
  void replaceTransposed(const std::vector<SparseRow>& rows, double* x) const;

private:
  std::vector<std::pair<std::size_t, std::size_t>> own_; ///< kept number and dof of this rank
  std::size_t size_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
};

/// E^T K E + springs of several bodies, one after another, whose kept dofs follow unknowns (JoinedUnknowns).
class JoinedOperator final : public FineOperator
{
public:
  JoinedOperator(const std::vector<const SolverProblem*>& bodies, Teuchos::RCP<const TpetraMap> dofMap,
                 const std::vector<int>& kept, const Comm& comm);
  void follow(const JoinedUnknowns& unknowns) { unknowns_ = unknowns; }

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return dofMap_; }
  void multiply(const TpetraVectors& x, double* y) const override;
  std::vector<double> inverseDiagonal() const override;
  int products() const override { return parts_.front()->products(); }

private:
  std::vector<Teuchos::RCP<BlockOperator>> parts_;
  std::vector<Teuchos::RCP<TpetraVectors>> moved_; ///< E x, per body
  Teuchos::RCP<const TpetraMap> dofMap_;
  KeptPlaces kept_;
  JoinedUnknowns unknowns_;
  mutable std::vector<double> work_;
};

} // namespace ndframe
