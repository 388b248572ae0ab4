#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/algebra/field.hpp"
#include "ndframe/base/registry.hpp"
#include "ndframe/coupling/role_spectrum.hpp"

namespace ndframe
{

/// The next interface traction and how it was found.
struct RelaxedTraction
{
  InterfaceValues traction; ///< Lambda_neu(p)
  double theta;             ///< the factor used, dimensionless
  std::string note;         ///< something the user should see in this sweep's line; usually empty
};

/// What a controller knows of earlier sweeps, in an order of its own.
using RelaxationMemory = std::vector<Vector>;

/// Chooses the relaxation factor theta_p of the update (18), (27):
///
///   Lambda_neu(p) = theta_p Lambda_dir(p) + (1 - theta_p) Lambda_neu(p-1).
class RelaxationController
{
public:
  virtual ~RelaxationController() = default;
  /// Forgets everything: a new run of the iteration begins.
  virtual void start() = 0;
  /// Whether it begins with startWith() and not with start().
  virtual bool needsSpectrum() const { return false; }
  /// As start(), knowing the eigenvalues that govern the sweeps.
  virtual void startWith(const RoleSpectrum&) { start(); }
  /// The factor of all sweeps, where the deck says it.
  virtual std::optional<double> givenTheta() const { return std::nullopt; }
  /// dirichlet: Lambda_dir(p), neumann: Lambda_neu(p-1), both at the interface's nodes, a stress.
  virtual RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& neumann) = 0;
  /// All that next() depends on but its arguments and how it was started.
  virtual RelaxationMemory memory() const = 0;
  /// Goes on, after start() or startWith(), as the controller did whose memory this is, with the same bits. False where
  /// it is not the memory of such a controller.
  virtual bool recall(const RelaxationMemory& memory) = 0;
};

/// The update (27) with a given factor.
InterfaceValues relax(const InterfaceValues& dirichlet, const InterfaceValues& neumann, double theta);

/// "Automatic", "Constant", "Aitken".
void registerRelaxations(Registry<RelaxationController>& registry);

} // namespace ndframe
