#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/log.hpp"
#include "ndframe/driver/certificate.hpp"
#include "ndframe/driver/energy_records.hpp"
#include "ndframe/driver/plan.hpp"
#include "ndframe/driver/solution.hpp"

namespace ndframe
{

/// Everything a run computed; the values that writers and tests look at.
struct Run
{
  Plan plan;
  Model model;
  CondensedModel condensed;
  std::optional<RoleSpectrum> spectrum; ///< of the sweeps, where the coupling needs it
  CouplingResult coupling;              ///< empty history without interfaces
  std::vector<InterfaceState>
      states; ///< those that are kept: the last one, or one per sweep; none when there is no solution
  std::vector<BodyFields> fields;                     ///< per body, per kept state
  std::vector<ContactNode> contact;                   ///< final state
  std::optional<Certificate> certificate;             ///< of the final state, when the deck asks for it
  std::shared_ptr<const ReferenceSolution> reference; ///< of this run or an earlier one; null if there was none
  EnergyRecords energies;                     ///< of all certificates of this run and of those that handed theirs on
  EnergyRecord energy;                        ///< of the scene of the last certificate
  int level = 0;                              ///< of a run with a target, from 1
  std::optional<Contradiction> contradiction; ///< of two certificates: neither is guaranteed (exit code 3)
  RunSummary summary;
  bool strictInput = false;  ///< of the deck: warnings are errors
  std::string failure;       ///< why there is no result or it may not be trusted (exit code 3); empty when it may
  std::string bug;           ///< what ended a run with a target on a later level (exit code 1); empty for none
  double startSeconds = 0.0; ///< wall clock when the run began
};

/// What a run may take over from the one before it.
struct Reusable
{
  Model model;
  CondensedModel condensed;
  std::shared_ptr<const ReferenceSolution> reference = nullptr;
  EnergyRecords energies = {};
};

/// Takes out of a run what the next one may take over; the answer stays.
Reusable handOn(Run& run);

/// Called after every level of a run with a target (level: from 1) with the solution and certificate on its mesh; the
/// summary only has names and sizes then.
using LevelObserver = std::function<void(const Run& run, int level)>;

/// Runs a validated deck up to the summary; writes no files. A deck with the list Accuracy is run on as many meshes as
/// its target needs and reuses nothing. Of `previous` it keeps what the deck has not changed, with
/// the same answer as without; the ledger must be the one of the run that it comes from.
/// Without a solution (a solver gives up, the load pulls a body off) the summary says so. Throws InputError for
/// mistakes that show only with the meshes; `previous` then holds what can still be reused.
Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous = {}, const LevelObserver& onLevel = {});

/// Makes an earlier (or empty) model the deck's and checks everything that --check checks: meshes, pairing, supports,
/// expectations. With a target the model is that of the first meshes.
void checkDeck(Model& model, const Params& deck, const Components& components, const Comm& comm, Ledger& ledger);

/// Writes NAME.level-01.e, ... if Output asks for all levels; else empty. Everything must live as long as the observer.
LevelObserver levelWriter(const Params& deck, const std::string& name, const Comm& comm, Ledger& ledger);

/// Writes what Output asks for; returns the files' names. Only rank 0 writes; a failure is everybody's InputError.
std::vector<std::string> writeResults(Run& run, const Params& deck, const std::string& name, const Comm& comm,
                                      Ledger& ledger);

} // namespace ndframe
