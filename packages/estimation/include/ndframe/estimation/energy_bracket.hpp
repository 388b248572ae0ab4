#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "ndframe/estimation/error_measure.hpp"

namespace ndframe
{

/// What one certificate says of the energy E(u) = a(u, u) / 2 - L(u) of the exact solution u: it lies between minus the
/// complementary energy of the equilibrated stress and the energy of the admissible displacement.
struct EnergyBracket
{
  double lower = -std::numeric_limits<double>::infinity(); ///< force times length; infinite: nothing is known
  double upper = std::numeric_limits<double>::infinity();  ///< not below `lower`, but for round-off
  double roundOff = 0.0; ///< what either may be wrong by in floating-point numbers, generously
};

/// The bracket of a certificate whose conditions all hold (docs/theory.md, section 8): with E^ = a(u^, u^) / 2 - L(u^),
///
///   E^ - w |l| - (W + |l|)^2 / 2 - int t^ (w^ - g)  <=  E(u)  <=  E^ + w |l|      (both + |l|^2 / 2),   w^2 = a(u^,
///   u^),
///
/// W the distance of the stresses widened by the loads' oscillation, l what prescribed displacements are not met by.
/// Limit: with |l| > 0 the loads must do no work on l.
/// strainEnergy: a(u^, u^). work: L(u^). imbalance: of the stress, relative to the forces.
EnergyBracket bracketEnergy(const ErrorMeasure& measure, double strainEnergy, double work, double imbalance = 0.0);

/// Two certificates of one scene that cannot both hold.
struct Contradiction
{
  /// Of the record's certificate, and of the one that was taken in.
  std::string earlier, later; ///< their names
  double lower = 0.0;         ///< by one of them the exact energy is not below this,
  double upper = 0.0;         ///< by the other one not above this, which is less
  bool newIsLower = false;    ///< the later one says `lower`
};

/// The best of all certificates of one scene. Weak duality holds between any two of them: no lower bound may lie above
/// any upper bound.
class EnergyRecord
{
public:
  /// Takes in a certificate; returns what it contradicts by more than both may be wrong by in round-off. `name`: what
  /// messages call it.
  std::optional<Contradiction> add(const EnergyBracket& bracket, const std::string& name);

  double lower() const { return lower_.value; }      ///< the largest one; minus infinity without a certificate
  double upper() const { return upper_.value; }      ///< the smallest one; infinite without a certificate
  bool holds() const { return holds_; }              ///< no two certificates contradict each other
  int certificates() const { return certificates_; } ///< number of those that were taken in

  /// An end of the bracket and the certificate that it is from.
  struct Side
  {
    /// Force times length; infinite without a certificate.
    double value = 0.0, roundOff = 0.0; ///< what the value may be wrong by, absolute
    std::string name;                   ///< of the certificate; empty without one
  };
  EnergyRecord() = default;
  /// Of certificates of an earlier process that hold together.
  EnergyRecord(Side lower, Side upper, int certificates)
      : lower_(std::move(lower)), upper_(std::move(upper)), certificates_(certificates)
  {}
  const Side& lowerSide() const { return lower_; } ///< lower() and where it is from
  const Side& upperSide() const { return upper_; } ///< upper() and where it is from

private:
  Side lower_{-std::numeric_limits<double>::infinity(), 0.0, {}},
      upper_{std::numeric_limits<double>::infinity(), 0.0, {}};
  int certificates_ = 0;
  bool holds_ = true;
};

} // namespace ndframe
