#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ndframe/certification/energy_summary.hpp"

namespace ndframe
{

/// One error measure of the certificate, absolute in the energy norm and relative to sqrt(a(u_h, u_h)).
struct ErrorMeasureSummary
{
  double absolute = 0.0;    ///< at most sqrt(elements^2 + contact^2) + projection + oscillation
  double relative = 0.0;    ///< 0 where the solution has no energy
  double elements = 0.0;    ///< |sigma^ - K eps(u^)|, the distance of the two stresses
  double contact = 0.0;     ///< sqrt(2 int t^ (w^ - g) dS)
  double projection = 0.0;  ///< |u^ - u_h|: what making the displacement admissible costs
  double oscillation = 0.0; ///< data that the polynomials do not carry
};

/// The true error as a finer solution shows it.
struct ReferenceSummary
{
  int refinements = 0;       ///< halvings of every edge
  std::int64_t dofs = 0;     ///< of the finer scene; 0: there is none
  std::string note;          ///< why it is coarser than asked; empty when it is not
  double displacement = 0.0; ///< |u_ref - u_h|, absolute
  double relative = 0.0;     ///< over sqrt(a(u_h, u_h)); NaN, as `displacement`, without a finer scene
  /// Errors of the equilibrated and of the mean stress, absolute in the energy norm.
  std::optional<double> stress, meanStress; ///< |sigma_ref - sigma^|, |sigma_ref - mean stress|: with Global
  /// The bound over `displacement`; absent without Global, or where the error is round-off.
  std::optional<double> effectivity, meanStressEffectivity; ///< its bound over `meanStress`
};

/// The certificate: Error Estimation of the deck.
struct ErrorSummary
{
  std::string mode;                             ///< "Strict", "Paper"
  std::string recovery;                         ///< "Star", "Global", "Element"; empty when no stress was recovered
  std::string interfaceTraction;                ///< "Optimal", "Projected"; empty without contact
  int degree = 0;                               ///< of the recovered stress; 0 without one
  bool guaranteed = false;                      ///< every condition of the bound was checked and holds
  std::string reason;                           ///< why not; empty when guaranteed
  std::optional<ErrorMeasureSummary> global;    ///< (39), (41): the bound
  std::optional<ErrorMeasureSummary> algorithm; ///< (50), an indicator
  std::optional<ErrorMeasureSummary> discretization; ///< (55), an indicator
  std::optional<double> splitStress;                 ///< |sigma^ - sigma~|, the mesh part of Split, absolute
  /// Absolute, and over sqrt(a(u_h, u_h)).
  std::optional<double> meanStress, meanStressRelative; ///< bound of the mean stress's error
  /// Of zienkiewiczZhu() and of residualIndicator(), in the energy norm.
  std::optional<double> zienkiewiczZhu, residual;  ///< unguaranteed comparisons, absolute
  std::optional<double> equilibrium;               ///< largest defect of the bound's stress, by Check Equilibrium
  std::optional<double> equilibriumDiscretization; ///< the same of the stress behind `discretization`
  std::optional<ReferenceSummary> reference;       ///< by the estimator Reference
  std::optional<EnergySummary> energyBracket; ///< of all certificates of the scene; absent without a guaranteed one
  std::string advice;                         ///< what would make the error smaller, in words; empty without both parts
};

} // namespace ndframe
