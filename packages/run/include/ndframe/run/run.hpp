#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/certification/certificate.hpp"
#include "ndframe/certification/energy_records.hpp"
#include "ndframe/condensation/solution.hpp"
#include "ndframe/interface/contact_transfer.hpp"
#include "ndframe/run/plan.hpp"

namespace ndframe
{

/// What solving a scene made.
struct Solved
{
  CouplingResult coupling; ///< empty history without interfaces
  std::vector<InterfaceState>
      states; ///< those that are kept: the last one, or one per sweep; none when there is no solution
  std::vector<BodyFields> fields;   ///< per body, per kept state
  std::vector<ContactNode> contact; ///< final state
  std::string doubt;                ///< why it is not the solution although it is one of the equations
  std::string failure;              ///< why there is none; empty when there is
};

/// What certifying a state made.
struct Certified
{
  std::optional<Certificate> certificate;             ///< none after a failure
  std::shared_ptr<const ReferenceSolution> reference; ///< null if there is none
  std::string failure;                                ///< why there is no certificate; empty when there is
};

/// Everything a run computed; the values that writers and tests look at.
struct Run
{
  Plan plan;                                          ///< stages of this run
  Model model;                                        ///< of the last mesh, with the roles that were chosen
  CondensedModel condensed;                           ///< of this model
  std::optional<RoleSpectrum> spectrum;               ///< of the sweeps, where the coupling needs it
  Solved solved;                                      ///< without states when there is no solution
  std::optional<Certificate> certificate;             ///< of the final state, when the deck asks for it
  std::shared_ptr<const ReferenceSolution> reference; ///< of this run or an earlier one; null if there was none
  EnergyRecords energies;                     ///< of all certificates of this run and of those that handed theirs on
  EnergyRecord energy;                        ///< of the scene of the last certificate
  int level = 0;                              ///< of a run with a target, from 1
  std::optional<Contradiction> contradiction; ///< of two certificates: neither is guaranteed (exit code 3)
  RunSummary summary;                         ///< names and sizes at first; complete after finishRun()
  bool strictInput = false;                   ///< of the deck: warnings are errors
  std::string failure;       ///< why there is no result or it may not be trusted (exit code 3); empty when it may
  std::string bug;           ///< what ended a run with a target on a later level (exit code 1); empty for none
  double startSeconds = 0.0; ///< wall clock when the run began
};

/// What a run may take over from the one before it.
struct Reusable
{
  Model model;                                                  ///< meshes and what stands on them; empty: all is read
  CondensedModel condensed;                                     ///< matrices and factors; empty: all is factored
  std::shared_ptr<const ReferenceSolution> reference = nullptr; ///< null if there is none
  EnergyRecords energies = {};                                  ///< of all scenes so far
  CarriedContact contact = {}; ///< what the next run's iteration begins with; empty: as its deck says
};

/// Takes out of a run what the next one may take over; the answer stays.
Reusable handOn(Run& run);

/// Called after every level of a run with a target (level: from 1) with the solution and certificate on its mesh; the
/// summary only has names and sizes then.
using LevelObserver = std::function<void(const Run& run, int level)>;

} // namespace ndframe
