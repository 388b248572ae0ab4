#pragma once

#include "ndframe/iterative/krylov_library.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

/// A symmetric operator on the dofs of this rank's nodes, zero where a dof is no unknown, as is what comes out.
class FineOperator : public TpetraOperator
{
public:
  /// y = A x for this rank's dofs.
  virtual void multiply(const TpetraVectors& x, double* y) const = 0;
  /// 1 / A_ii, zero where a dof is no unknown.
  virtual std::vector<double> inverseDiagonal() const = 0;
  virtual std::vector<std::int64_t> numbers() const = 0; ///< of the dofs, the same on any number of ranks
  virtual int products() const = 0;                      ///< so far
  virtual Traffic traffic() const = 0;                   ///< of this rank, so far

  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return getDomainMap(); }
  void apply(const TpetraVectors& x, TpetraVectors& y, Teuchos::ETransp mode, double alpha, double beta) const override;
};

/// P and P^T between a level and a coarser one.
class FineTransfer
{
public:
  virtual ~FineTransfer() = default;
  /// coarse = P^T fine
  virtual void toCoarse(const double* fine, TpetraVectors& coarse) = 0;
  /// fine = P coarse; what is no unknown is set to zero, in `coarse` too
  virtual void toFine(TpetraVectors& coarse, double* fine) = 0;
  virtual Traffic traffic() const = 0; ///< of this rank, so far
};

} // namespace ndframe
