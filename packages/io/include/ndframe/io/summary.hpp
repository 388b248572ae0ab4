#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/build_info.hpp"
#include "ndframe/io/accuracy_summary.hpp"
#include "ndframe/io/body_summary.hpp"
#include "ndframe/io/error_summary.hpp"
#include "ndframe/io/probe_summary.hpp"

namespace ndframe
{

// What a run leaves in NAME.summary.json. Plain values; docs/summary.schema.json describes the file.

/// What a user should look at although nothing is forbidden.
struct WarningSummary
{
  std::string kind; ///< of the check, e.g. "large strain"
  std::string message;
};

/// The end of contact between two nodes: the nearest that is closed and pressed, the nearest that is open with a gap.
struct EndBracket
{
  std::vector<double> closed, open; ///< coordinates
};

/// Contact of two sides in the final state. In plane scenes forces are those of a slice of thickness 1.
struct InterfaceSummary
{
  std::string name;
  std::string dirichletBody, neumannBody;
  int nodes = 0;
  int closedNodes = 0;
  std::vector<double> forceOnDirichlet;       ///< resultant vector of t_dir on the Dirichlet body
  std::vector<double> forceOnNeumann;         ///< resultant vector of -t_neu on the Neumann body
  double contactForce = 0.0;                  ///< - int t_dir . n_c dS, positive in compression
  bool isArea = false;                        ///< bodies in space touch on areas
  double contactMeasure = 0.0;                ///< sum of int psi_i dS over the closed nodes i: a length or an area
  std::vector<std::vector<double>> endPoints; ///< of the closed nodes: the two farthest apart; in space, of their box
  std::vector<EndBracket> endBrackets;        ///< where contact ends inside the interface (2-D)
  double largestPressure = 0.0;
  double largestPenetration = 0.0; ///< max (u1_N - u2_N - g) over the nodes, 0 if none
};

/// One sweep of a Neumann-Dirichlet iteration, in the words of the paper; other couplings have one entry.
struct SweepSummary
{
  int sweep = 0;
  double epsTau = 0.0;
  double theta = 0.0;
  int statusChanges = 0;
  int statusPasses = 0;
  int closed = 0;
  int open = 0;
  double forceOnDirichlet = 0.0; ///< resultants along n_c: int t_dir
  double forceOnNeumann = 0.0;   ///< int t_neu
  double penetration = 0.0;
  std::string note; ///< e.g. "theta clipped"
};

/// Roles that were chosen for bodies that touch, directly or through others (Dirichlet Body = Automatic).
struct RoleSummary
{
  std::vector<std::string> dirichletBodies, neumannBodies;
  bool exchanged = false;   ///< against the deck
  double contraction = 0.0; ///< of the traction's error in a sweep with `theta`
  double theta = 0.0;       ///< relaxation factor: the deck's, or the best
  double bestTheta = 0.0;
  std::optional<double> contractionExchanged; ///< with the other roles; none where supports leave no choice
};

struct CouplingSummary
{
  std::string type;
  int sweeps = 0;
  bool converged = false;
  std::string reason; ///< why it stopped, one sentence
  std::vector<SweepSummary> history;
  std::vector<RoleSummary> roles; ///< one per connected part of the network; empty when they were given
};

/// True residuals of the returned state, each relative to a scale of the same unit (0 is perfect).
struct ResidualSummary
{
  double equilibrium = 0.0; ///< largest |K u - f - contact force| over the free dofs / largest nodal load or reaction
  double complementarity =
      0.0;                  ///< largest |(u1_N - u2_N - g)_i (C Lambda)_i| / (largest |gap or u| * largest nodal force)
  double penetration = 0.0; ///< largest positive u1_N - u2_N - g / largest |u|
  double tension = 0.0;     ///< largest positive nodal contact force / largest nodal force
  double allowedInContact = 0.0; ///< the last three, by a coupling that was told to stop early
};

struct StageSummary
{
  std::string name;
  double seconds = 0.0;
  std::int64_t peakBytes = 0;
};

struct ExpectationSummary
{
  std::string name;
  double value = 0.0; ///< computed
  double expected = 0.0;
  double tolerance = 0.0;
  bool met = false;
};

/// Everything in NAME.summary.json (docs/summary.schema.json), in the units of the deck.
struct RunSummary
{
  std::string version;
  BuildInfo build;
  std::string title;
  std::string deckJson; ///< the effective deck (base/params.hpp: toJson)
  int ranks = 1;
  bool perUnitThickness = true; ///< a plane scene: forces and energies are those of a slice of thickness 1
  bool solved = true;           ///< false: the run ended without a solution, whose numbers then are null in the file
  std::vector<BodySummary> bodies;
  double energy = 0.0; ///< sum over bodies
  std::vector<InterfaceSummary> interfaces;
  std::vector<ProbeSummary> probes;        ///< none: the deck has none
  std::optional<CouplingSummary> coupling; ///< absent without interfaces
  ResidualSummary residuals;
  std::vector<WarningSummary> warnings;
  std::optional<ErrorSummary> errors;      ///< absent without Error Estimation
  std::optional<AccuracySummary> accuracy; ///< absent without Accuracy
  std::vector<ExpectationSummary> expectations;
  std::map<std::string, std::int64_t> counts;
  std::vector<StageSummary> stages;
  double totalSeconds = 0.0;
  std::int64_t peakBytes = 0;
};

/// The summary as JSON text (two-space indentation; numbers in the shortest form that reads back exactly; NaN and
/// infinity are null).
std::string toJson(const RunSummary& summary);

/// Looks a number up by a path such as "bodies/punch/energy", "interfaces/contact/contact_force", "coupling/sweeps",
/// "energy", "ledger/counts/factorisations": list entries are found by their "name" (or by index). Booleans count as
/// 0/1. Empty when there is no finite number at that path.
std::optional<double> summaryValue(const RunSummary& summary, const std::string& path);

} // namespace ndframe
