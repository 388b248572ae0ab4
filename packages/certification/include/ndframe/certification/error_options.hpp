#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ndframe/base/list_place.hpp"

namespace ndframe
{

class StressRecovery;

/// What can be said about the error.
enum class Estimator
{
  Global,         ///< (39), (41): the bound
  Algorithm,      ///< (50): what the stopped iteration adds, an indicator
  Discretization, ///< (55): what the mesh adds, an indicator
  Split,          ///< the bound as |sigma^ - sigma~| and the iteration's part
  Reference,      ///< the error against a finer solution
  ZienkiewiczZhu, ///< stress smoothing, for comparison
  Residual        ///< residuals and jumps, for comparison
};

/// Strict: everything that makes the bound a bound. Paper: u^ = u_h, although it may penetrate between the nodes.
enum class ErrorMode
{
  Strict,
  Paper
};

/// The admissible traction: the one that makes the bound small, or the paper's projection of the computed one.
enum class TractionType
{
  Automatic, ///< Optimal where the recovery can choose the traction, else Projected
  Optimal,
  Projected
};

/// The traction of the Neumann side in the mean that is projected: the one that its body is in equilibrium with,
/// or the one relaxed after the last sweep.
enum class TractionMean
{
  Previous,
  Updated
};

/// How a deck calls the values of each enumeration.
const Names<Estimator>& estimatorNames();
const Names<ErrorMode>& errorModeNames();       ///< of Mode
const Names<TractionType>& tractionTypeNames(); ///< of Traction
const Names<TractionMean>& tractionMeanNames(); ///< of the traction's mean

/// A bound of the displacement's error that is enough; 0: there is none.
struct EnoughBound
{
  double value = 0.0;
  bool isRelative = false; ///< value is over the energy norm of the solution

  /// Of a bound a thousandth below: those that are found step by step do not know of all. norm: of the solution.
  double square(double norm) const;
};

/// The list Error Estimation, read.
struct ErrorOptions
{
  ListPlace place;                    ///< for mistakes that show later
  std::vector<Estimator> estimators;  ///< those of the deck; without the key Global and, with interfaces, its two parts
  ErrorMode mode = ErrorMode::Strict; ///< what u^ is, and what a guarantee takes
  TractionType tractionType = TractionType::Automatic; ///< as the deck has it; tractionWith() decides
  TractionMean tractionMean = TractionMean::Previous;  ///< for the projection, from which Optimal begins, too
  std::string recovery;                                ///< name of the component
  Params recoveryList = Params(nullptr);               ///< for its builder
  bool checkEquilibrium = false;                       ///< of the recovered stresses, cell by cell
  bool requireGuarantee = false;                       ///< a bound that is not guaranteed is a failed run
  int refinements = 0;                                 ///< of the reference: halvings of every edge
  std::int64_t maximumDofs = 0;                        ///< of the reference
  bool touches = false;                                ///< the deck has interfaces
  EnoughBound enough;                                  ///< of a run with a target

  bool wants(Estimator estimator) const; ///< it is among the estimators
  bool needsGlobalField() const;         ///< one admissible traction on both sides and the fields u~ in balance with it
  bool needsTraction() const;            ///< that or the tractions of the separate problems
  bool recoversGlobalStress() const;     ///< the equilibrated stress of the bound
  bool recoversStress() const;           ///< that or the one of the separate problems
  /// Optimal or Projected.
  TractionType tractionWith(const StressRecovery& component, int dim) const;
  /// The recovery changes the traction.
  bool optimises(const StressRecovery& component, int dim) const;
};

} // namespace ndframe
