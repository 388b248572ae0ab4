#pragma once

#include <optional>
#include <string>

namespace ndframe
{

/// A number that is known to lie between two others.
struct NumberBracket
{
  /// At most the number.
  double lower = 0.0, upper = 0.0; ///< at least the number
};

/// What follows from the energy where one cause alone moves the bodies: with one load the mean displacement along it,
/// with one prescribed displacement the force along it, in both cases force over displacement.
struct DriveSummary
{
  std::string cause; ///< "press of punch"
  /// Resultant of the load, or of the support along its displacement.
  NumberBracket force, displacement, /**< mean along the load, or prescribed */ stiffness; ///< force over displacement
};

/// The energy of the exact solution, a(u, u) / 2 - L(u), guaranteed; the best of all certificates of the run.
struct EnergySummary
{
  NumberBracket energy;              ///< force times length; per unit thickness in the plane
  double relativeWidth = 0.0;        ///< upper - lower, over a(u_h, u_h) / 2: the square of a relative bound
  int certificates = 0;              ///< that the bracket comes from
  std::optional<NumberBracket> work; ///< of loads or of prescribed displacements, where it follows
  std::string workOf;                ///< "the loads", "the supports"; empty without work
  std::optional<DriveSummary> drive; ///< absent unless one constant load or moving support is all that acts
};

} // namespace ndframe
