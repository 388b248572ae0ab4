#pragma once

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/subdomain/unilateral_problem.hpp"

namespace ndframe
{

/// The bodies that are Dirichlet (or Neumann) bodies, as one operator on the interface unknowns; zero at obstacles that
/// none of them meets.
struct RoleSystem
{
  std::shared_ptr<const SymmetricOperator> S;
  Vector g;
  DenseMatrix freeMotions;
  std::vector<std::string> motionNames;
};
RoleSystem gatherRole(const InterfaceSystem& system, ContactRole role);

/// Those of the motions (columns) that leave the held unknowns at rest.
DenseMatrix motionsAtRest(const DenseMatrix& motions, const std::vector<char>& isHeld);

/// All bodies on the unknowns (w, d): w = u1_N - u2_N the jump, d = u2_N. At obstacles w is the free body's
/// displacement and d in no body's operator.
RoleSystem gatherJump(const InterfaceSystem& system);

/// Statuses before the first sweep: those of the start, if it has some; else all closed, or all open where bodies that
/// do not float have a gap at every node: then one pass shows that they stay apart.
std::vector<char> firstStatuses(const InterfaceSystem& system, bool floats, const CouplingStart& start);

/// The same for status passes, after every one; `sweeps` must outlive it. Throws InputError where it goes on from
/// sweeps.
PassesKept passesOf(const SweepsKept& sweeps);

/// Whether no node is closed and no traction left: each body is solved by itself.
bool areApart(const SweepRecord& last);
inline constexpr const char* apart = "the bodies do not touch: each is solved by itself";

/// What one sweep has to report.
SweepRecord recordSweep(int sweep, const InterfaceSystem& system, const InterfaceState& state,
                        const UnilateralState& status);

/// What a coupling returns that solves all bodies in one go. reason: why it stopped, where they touch.
CouplingResult settled(const InterfaceSystem& system, InterfaceState state, const UnilateralState& status,
                       const std::string& reason);

/// A coupling with the parameters of Neumann-Dirichlet.
struct SweepsEntry
{
  const char *name, *doc;
  std::function<std::unique_ptr<Coupling>(std::unique_ptr<Coupling> sweeps)> wrap; ///< what is made of these
};
void registerSweeps(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations,
                    const SweepsEntry& entry);

std::unique_ptr<Coupling> makeMonolithic();
inline constexpr const char* monolithicName = "Monolithic";
inline constexpr const char* neumannDirichletName = "Neumann-Dirichlet";

void registerAutomaticCoupling(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations);
void registerNeumannDirichlet(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations);
void registerMonolithic(Registry<Coupling>& registry);
void registerFeti(Registry<Coupling>& registry);
void registerNeumannNeumann(Registry<Coupling>& registry);

} // namespace ndframe
