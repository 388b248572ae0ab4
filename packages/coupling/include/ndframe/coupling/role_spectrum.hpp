#pragma once

#include <vector>

#include "ndframe/base/ledger.hpp"
#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{

/// The eigenvalues mu that govern the Neumann-Dirichlet iteration while no status changes:
///
///   S_D x = mu S_N x,
///
/// S_D and S_N the condensed stiffnesses of the Dirichlet and of the Neumann bodies. A sweep turns the error e of the
/// traction into (1 - theta (1 + mu)) e. A free motion of the Dirichlet bodies adds mu = 0; one of the Neumann bodies
/// (mu infinite) adds nothing, for its amplitude is found by the unilateral problem.
struct RoleSpectrum
{
  /// Extreme eigenvalues mu, dimensionless.
  double smallest = 0.0, largest = 0.0; ///< of the motions that strain both sides; 0 when there is none
  /// A Dirichlet body has free motions: mu = 0, too.
  bool dirichletFloats = false, neumannFloats = false; ///< a Neumann body has free motions, which add nothing

  /// False when a stiffness on the interface is lost in round-off; the eigenvalues are then NaN.
  bool isKnown() const;
  /// The factor max |1 - theta (1 + mu)| with the best theta = 2 / (2 + mu_min + mu_max), and that theta.
  double contraction() const;
  double bestTheta() const; ///< theta: at most 1, NaN if nothing is known
  /// The same factor with a given theta; above 1 the iteration diverges.
  double contraction(double theta) const;
  /// With the roles exchanged: mu becomes 1/mu.
  RoleSpectrum exchanged() const;
};

/// Bodies that touch, directly or through others: their roles can be chosen without regard to the rest.
struct ConnectedBodies
{
  std::vector<int> bodies; ///< their numbers in the list of bodies, ascending
  RoleSpectrum spectrum;   ///< for the roles that they have; NaN: isKnown() is false
};

/// The connected parts of the network of bodies with the spectra of the roles they have; the extreme eigenvalues come
/// from some Lanczos steps, each as expensive as a linear sweep ("role steps" in the ledger), and are good to some
/// percent.
std::vector<ConnectedBodies> roleSpectra(const InterfaceSystem& system, Ledger& ledger);

/// The eigenvalues of all parts together, for a theta that all have in common.
RoleSpectrum joinedSpectrum(const std::vector<ConnectedBodies>& parts);

} // namespace ndframe
