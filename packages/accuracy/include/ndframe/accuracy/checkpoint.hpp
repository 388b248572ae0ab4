#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/run/run_summary.hpp"
#include "ndframe/run/shared_passes.hpp"

namespace ndframe
{

/// What the certificate of a mesh says to a run with a target; absolute, in the energy norm.
struct LevelNumbers
{
  double bound = 0.0;     ///< what is compared with the target
  double target = 0.0;    ///< of the bound
  double relative = 0.0;  ///< the bound over the norm of the solution
  double iteration = 0.0; ///< the part of the stopped sweeps
  double mesh = 0.0;      ///< the rest of the bound of the displacement's error
  double contact = 0.0;   ///< in the bound: tractions across openings, of the mesh or left by the sweeps
};

/// Where contact ends, on an interface of this length (2-D).
struct EndOnSide
{
  EndBracket bracket;  ///< the nodes on either side of the end
  double length = 0.0; ///< of the whole interface, the sum of its facets
};

/// What the meshes after a level are made from.
struct LevelLesson
{
  LevelNumbers errors;                            ///< the bound and its parts
  std::vector<std::vector<double>> contributions; ///< eta_K per elastic body and cell of its mesh as it was refined
  std::vector<std::array<int, 2>> ends;           ///< body (among those) and vertex: where contact ends
  std::vector<EndOnSide> brackets;                ///< of all interfaces; none in space
};

/// One end of the bracket of the exact energy, and the certificate that it is from.
struct EnergyEnd
{
  /// Force times length; infinite without a certificate.
  double value = 0.0, roundOff = 0.0; ///< what the value may be wrong by, absolute
  std::string name;                   ///< of the certificate, "level 3"; empty without one
};

/// The bracket of the exact energy by the certificates so far.
struct EnergyEnds
{
  EnergyEnd lower, upper; ///< the best of all
  int certificates = 0;   ///< of them
};

/// All that a level of a run with a target leaves to those after it, apart from what is made from it again: meshes by
/// the same refinements, interfaces from the meshes.
struct LevelRecord
{
  LevelSummary summary;         ///< as NAME.summary.json has it
  LevelLesson lesson;           ///< what the next meshes are planned with
  std::int64_t maximumDofs = 0; ///< with which the next meshes were planned; 0: they were not
  std::string meshes;           ///< hash of the bodies' meshes, by which they are known again
  /// Traction with which the next sweep would begin, (27); zero at open nodes.
  std::vector<double> nextTraction, tractionNeumann; ///< per interface node, one interface after another
  std::vector<int> closed;                           ///< per interface node
  std::vector<int> dirichletBodies;                  ///< per interface
  std::vector<RoleSummary> roles;                    ///< that were chosen; empty where they were given
  EnergyEnds energy;                                 ///< with this level's
};

/// The sweeps or status passes of a level that was not done, or of a run without levels.
struct SweepsRecord
{
  SweepsDone done;            ///< since they began with a goal of their own
  std::optional<double> goal; ///< for their part of the error; none: Coupling/Stopping
  bool isRough = false;       ///< Exactness::Rough, where they are passes
  int before = 0;             ///< sweeps on this mesh with larger goals
  /// What those left of it and of the bound; infinite without any.
  double iterationBefore = std::numeric_limits<double>::infinity(), boundBefore = iterationBefore; ///< in energy norm
  EnergyEnds energy;                                                                               ///< with theirs
};

/// What a stage of the ledger took.
struct StageRecord
{
  std::string name;           ///< as the ledger calls it, "factor"
  double seconds = 0.0;       ///< wall-clock time of all its passes
  std::int64_t peakBytes = 0; ///< largest resident size while it ran
};

/// NAME.checkpoint: what a run that was ended goes on from.
struct Checkpoint
{
  std::string version;                ///< of ndframe
  std::string deckJson;               ///< effective
  bool isFinished = false;            ///< the run has come to its end: nothing of what follows but its files
  std::vector<std::string> results;   ///< names of the files that a finished run wrote; else empty
  std::vector<LevelRecord> levels;    ///< that are done, the first one first; none of a finished run
  std::optional<SweepsRecord> sweeps; ///< on the meshes after them
  SharedPasses shared;                ///< belongs to them where they are passes of bodies that ranks have shares of
  int pieces = 0;                     ///< then the fields and their places are in so many files, one of each rank,
  std::string stamp;                  ///< whose names have this
  /// Displacements of the last level, where iterations on the next meshes begin with them; else empty.
  std::vector<Vector> solution; ///< per elastic body and node, global axes
  double seconds = 0.0;         ///< since the run began
  /// Largest resident sizes of rank 0: when the first process began, and of all processes so far.
  std::int64_t firstMemory = 0, peakMemory = 0; ///< bytes, before there was a mesh and the most
  std::map<std::string, std::int64_t> counts;   ///< of the ledger
  std::vector<StageRecord> stages;              ///< of the ledger
};

/// "Bodies/punch/Material/Young Modulus is 2 and was 1" of the first parameter in which two effective decks differ, and
/// how many more there are; empty when they are the same but for title, Output, Expect, the limits of Accuracy and
/// Maximum Sweeps.
std::string differenceOf(const std::string& deckJson, const std::string& earlierJson);

} // namespace ndframe
