#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "ndframe/run/run.hpp"
#include "ndframe/run/run_observer.hpp"

namespace ndframe
{

/// What the steps of a run work with.
struct RunTools
{
  /// Builds coupling and linear solver as the deck names them. Everything must live as long as the tools.
  RunTools(const RunSettings& settings, const CertificateComponents& components, const Comm& comm, Ledger& ledger);

  const RunSettings& settings;             ///< of the deck
  const CertificateComponents& components; ///< that the deck may name
  const Comm& comm;                        ///< all processes of the run
  Ledger& ledger;                          ///< counts and times the steps
  std::unique_ptr<Coupling> coupling;      ///< never null
  std::unique_ptr<LinearSolver> solver;    ///< never null
  std::optional<ErrorOptions> errors;      ///< what is estimated; none without the list Error Estimation
};

/// Makes an earlier (or empty) model the deck's and checks it. meshes: empty, or those to be used instead of the
/// deck's.
void readModel(Model& model, const RunTools& tools, const MeshOfBody& meshes = {});

/// The scene on the meshes of a level of which ranks can have shares, in place of a model whose interfaces are earlier
/// ones; false where they cannot, and nothing is changed. meshes: of bodies that are not rigid, on every rank.
/// Collective.
bool shareLevel(Model& model, const std::vector<Mesh>& meshes, const RunTools& tools);

/// Matrices, factors, Schur complements; previous: taken over where it is the same.
CondensedModel condense(const Model& model, CondensedModel&& previous, const RunTools& tools, RunObserver& observer);

/// The same into the run.
void condenseRun(Run& run, const RunTools& tools, RunObserver& observer);

/// What the coupling wants to know before the first sweep.
struct FoundRoles
{
  std::optional<RoleSpectrum> spectrum; ///< if the coupling needs it
  std::vector<RoleSummary> parts;       ///< per connected part; empty where roles were given
};

/// Exchanges the roles of the bodies of a condensed scene, if they are to be found and others are better. before: roles
/// of an earlier mesh; may be empty.
FoundRoles findRoles(Model& model, CondensedModel& condensed, const std::vector<RoleSummary>& before,
                     const RunTools& tools);

/// The same into the run, where bodies are coupled.
void findRoles(Run& run, const RunTools& tools, RunObserver& observer);

/// Sweeps, displacements, contact. Where there is no solution and that lies in the problem, the result says why. start:
/// with the spectrum that the coupling needs (Run::spectrum).
Solved solve(Model& model, CondensedModel& condensed, const RunTools& tools, RunObserver& observer,
             const CouplingStart& start);

/// The same into the run, whose certificate is of another state then. Throws NotConverged without a solution.
void solveRun(Run& run, const RunTools& tools, RunObserver& observer, CouplingStart start = {});

/// The certificate of a solution. reference: of this run or an earlier one; may be null. Matrices of bodies that are
/// solved by iterations are given back meanwhile; solve() makes them again.
Certified certify(const Model& model, CondensedModel& condensed, const Solved& solved,
                  std::shared_ptr<const ReferenceSolution> reference, const RunTools& tools);

/// The certificate of the run's last state; without one Run::failure says why.
void certifyRun(Run& run, const RunTools& tools);

/// Takes steps that may fail where that lies in the problem; then the run is left without a solution, and says why.
void attempt(Run& run, RunObserver& observer, const std::function<void()>& steps);

/// The summary, and in Run::failure why the result may not be trusted.
void finishRun(Run& run, const RunTools& tools);

} // namespace ndframe
