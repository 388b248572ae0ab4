#pragma once

#include "fine_level.hpp"
#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

/// One symmetric cycle on two levels as a preconditioner of K, x = B b:
///
///   x = p(b),   x += P C P^T (b - K x),   x += p(b - K x),
///
/// p a polynomial of D^-1 K (Chebyshev's on [lmax / 5, 1.1 lmax], `degree` terms), C an approximation of the inverse on
/// the vertices. Takes 2 degree products. P and C only see unknowns: a coarse preconditioner that keeps the rigid
/// motions returns values in held dofs, too, and CG would then solve another problem.
class TwoLevelCycle final : public TpetraOperator
{
public:
  /// largest: eigenvalue of D^-1 K; 0: that of the matrix as it is now is found.
  TwoLevelCycle(Teuchos::RCP<const FineOperator> matrix, std::unique_ptr<FineTransfer> transfer, double largest = 0.0);
  void dropCoarse() { coarse_.reset(); } ///< its memory is needed; setCoarse() must follow
  void setCoarse(const TpetraSystem& system, const Preconditioner& coarse);
  void shareCoarse(const TwoLevelCycle& other); ///< that which the other one has now
  /// The matrix has another diagonal, and no larger eigenvalue.
  void takeDiagonal() { inverseDiagonal_ = matrix_->inverseDiagonal(); }

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return matrix_->getDomainMap(); }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return matrix_->getRangeMap(); }
  /// alpha = 1, beta = 0 whatever is given.
  void apply(const TpetraVectors& b, TpetraVectors& x, Teuchos::ETransp mode, double alpha, double beta) const override;

  double largestEigenvalue() const { return largest_; }
  int cycles() const { return cycles_; } ///< so far
  Traffic traffic() const;               ///< of transfers and coarse level, of this rank, so far

private:
  void cycle(const double* b, double* x) const;
  /// Further terms of the polynomial after the first: residual_ and step_ go along. The last residual only if wanted.
  void smooth(double* x, bool wantsResidual) const;

  static constexpr int degree = 2, lanczosSteps = 20;
  static constexpr double smoothedShare = 5.0, margin = 1.1;

  Teuchos::RCP<const FineOperator> matrix_;
  std::vector<double> inverseDiagonal_;
  double largest_;            ///< eigenvalue of D^-1 K
  double centre_, halfWidth_; ///< of the interval
  std::unique_ptr<FineTransfer> transfer_;
  std::shared_ptr<PreconditionerHandle> coarse_;
  mutable std::vector<double> residual_, product_;
  mutable Teuchos::RCP<TpetraVectors> step_, nextStep_, coarseLoad_, coarseSolution_;
  mutable int cycles_ = 0;
  mutable Traffic coarseTraffic_;
};

/// Of both so far.
CycleWork workOf(const FineOperator& matrix, const TwoLevelCycle& cycle);

} // namespace ndframe
