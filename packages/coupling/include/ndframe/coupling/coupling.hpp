#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/base/ledger.hpp"
#include "ndframe/base/registry.hpp"
#include "ndframe/coupling/relaxation_controller.hpp"
#include "ndframe/interface/body_trace.hpp"
#include "ndframe/subdomain/status_method.hpp"

namespace ndframe
{

/// The interface state after a sweep. The final state pairs u1, Lambda_dir(p) with u2, Lambda_neu(p-1).
struct InterfaceState
{
  /// Normal displacements along n_c of the Dirichlet bodies, a length (InterfaceSystem).
  UnknownValues uDirichlet, uNeumann; ///< normal displacements
  Vector motionsNeumann; ///< amplitudes of the Neumann bodies' free motions, if the coupling finds them separately
  UnknownValues
      strainedNeumann; ///< then uNeumann without them: a large motion costs the sum the digits of small strains
  /// Nodal forces along n_c on the Dirichlet bodies, negative in compression.
  UnknownValues forceDirichlet, forceNeumann; ///< C Lambda_dir, C Lambda_neu
  /// Nodal traction of the Dirichlet bodies along n_c, a stress; negative in compression.
  InterfaceValues tractionDirichlet, tractionNeumann; ///< Lambda (all nodes of the contact matrix)
  std::vector<char> closed;                           ///< status per unknown
  /// The interiors too where the coupling found them, in the order of InterfaceSystem::bodies: u in the nodes' own
  /// axes, zero on fixed dofs.
  std::vector<NodalField> fields;
};

/// One line of the history.
struct SweepRecord
{
  int sweep = 0;       ///< counted from 1
  double epsTau = 0.0; ///< |Lambda_dir - Lambda_neu| / (1/2 |Lambda_dir + Lambda_neu|)
  /// With a goal for it: half the distance between Lambda_dir and Lambda_neu in the energy norm of the bodies. FETI,
  /// whose forces are those of both: what its displacements are wrong by for their statuses, at most, and what makes
  /// them admissible.
  std::optional<double> iterationError;
  double theta = 0.0; ///< factor used for the next traction; 0 where there is none
  /// Number of unknowns whose status the sweep changed.
  int statusChanges = 0, statusPasses = 0;         ///< linear solves of the status method
  int closed = 0, open = 0;                        ///< numbers of unknowns after the sweep
  double forceDirichlet = 0.0, forceNeumann = 0.0; ///< resultants int t_N dS of Lambda_dir and Lambda_neu
  bool turned = false;      ///< Lambda_dir - Lambda_neu points against that of the sweep before: a step too long
  double penetration = 0.0; ///< max (u1_N - u2_N - g), at least 0
  std::string note;         ///< for the user; usually empty
};

/// What a coupling returns: the last state, how it came there, and why it stopped.
struct CouplingResult
{
  InterfaceState state;             ///< after the last sweep
  std::vector<SweepRecord> history; ///< one record per sweep
  bool converged = false;           ///< else `state` is that of an unfinished iteration
  double contactTolerance = 0.0; ///< what the state may penetrate and pull by, relative, as the deck asked for no more
  std::string type;              ///< the coupling that solved it, where another one was asked to choose
  std::string reason;            ///< why it stopped: "eps_tau 0.091 < 0.1", "iteration 0.00031 < 0.001 (energy norm)"
};

/// What sweeps that are done leave to those that follow, or the passes of a coupling without sweeps. On the same bodies
/// these have the same bits as if they had followed at once.
struct SweepsDone
{
  std::vector<SweepRecord> history;           ///< all of them
  InterfaceState state;                       ///< after the last one
  InterfaceValues traction;                   ///< with which the next one begins
  RelaxationMemory relaxation;                ///< of the controller
  std::map<std::string, std::int64_t> counts; ///< of the ledger
  std::optional<StatusPasses> passes;         ///< then nothing of the above
};

/// Sweeps that go on from earlier ones, and are kept so that others may go on from them.
struct SweepsKept
{
  std::optional<SweepsDone> after; ///< none: they begin with the first
  int every = 0;                   ///< after so many sweeps each, those that are done are kept; 0: never
  std::function<void(const SweepsDone&)> keep = {}; ///< how
};

/// Where an iteration begins, and when it may end, if not as the deck says. All may be empty.
///
/// A wrong start costs sweeps and status passes and changes nothing in the answer beyond the stopping tolerance: the
/// traction is corrected to carry the loads of floating bodies, without which a Neumann problem has no solution, and
/// statuses that do not hold a body are changed. Monolithic, which has no iteration, uses the statuses only.
struct CouplingStart
{
  InterfaceValues traction; ///< Lambda_0 (nodes of the contact matrix); empty: Initial Traction
  std::vector<char> closed; ///< status per unknown; empty: all closed, if the bodies may touch
  /// Given: SweepRecord::iterationError is measured. > 0: the sweeps end below it, which replaces Tolerance.
  std::optional<double> iterationError;
  std::optional<RoleSpectrum> spectrum = {}; ///< of the sweeps, if it is known already (Coupling::needsSpectrum)
  SweepsKept sweeps = {};                    ///< or status passes, where there are no sweeps
  /// What InterfaceState::fields begin with where the coupling finds them. Empty: with zero.
  std::vector<NodalField> fields = {};
  Exactness exactness = Exactness::Full; ///< of them
};

/// Called after every sweep, for the screen and for those who want all states.
using SweepObserver = std::function<void(const SweepRecord&, const InterfaceState&)>;

/// What a coupling makes of the names Dirichlet and Neumann body. Where they are roles, a body has one role on all its
/// interfaces.
enum class Roles
{
  None,     ///< all bodies are treated alike; the names only orient the interface
  AsGiven,  ///< as the deck says
  Automatic ///< chosen by the driver before solve(): the better contraction (role_spectrum.hpp)
};

/// Whether every body has one role on all its interfaces, none that is a Neumann body meets an obstacle, and contact is
/// asked of every unknown by itself.
bool haveRoles(const InterfaceSystem& system);

/// How the bodies are brought together on the interface.
class Coupling
{
public:
  virtual ~Coupling() = default;
  /// Throws NotConverged when there is no state to return at all (the load does not press the bodies together).
  virtual CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                               const CouplingStart& start = {}) const = 0;
  virtual Roles roles() const = 0; ///< what Dirichlet and Neumann body mean to it
  /// Whether solve() needs a role for every body (haveRoles). False where it can do without.
  virtual bool needsRoles() const { return roles() != Roles::None; }
  /// Whether roles and the eigenvalues of sweeps mean anything to solve() of this system.
  virtual bool sweeps(const InterfaceSystem& system) const { return haveRoles(system); }
  /// Whether solve() takes bodies of so many dimensions as they are, without their Schur complements, where their
  /// solver offers it (WholeSolver).
  virtual bool solvesWhole(int /*dim*/) const { return false; }
  /// Whether it keeps sweeps, and not only passes. solve() throws InputError where they are not those of the system.
  virtual bool keepsSweeps() const { return false; }
  /// Whether solve() finds the eigenvalues of the sweeps unless the start has them.
  virtual bool needsSpectrum() const { return false; }
  /// The relaxation factor of all sweeps, where the deck says it: what roles are chosen for.
  virtual std::optional<double> givenTheta() const { return std::nullopt; }
};

/// "Automatic", "Neumann-Dirichlet", "Monolithic", "FETI", "Neumann-Neumann". The relaxation controllers must be
/// registered before; their registry must outlive this one.
void registerCouplings(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations);

} // namespace ndframe
