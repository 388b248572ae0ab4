#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/build_info.hpp"
#include "ndframe/certification/error_summary.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/condensation/solution.hpp"
#include "ndframe/run/accuracy_summary.hpp"
#include "ndframe/run/body_summary.hpp"
#include "ndframe/run/probe_summary.hpp"

namespace ndframe
{

/// What a user should look at although nothing is forbidden.
struct WarningSummary
{
  std::string kind;    ///< of the check, e.g. "large strain"
  std::string message; ///< path in the deck, if there is one, and the sentence
};

/// The end of contact between two nodes: the nearest that is closed and pressed, the nearest that is open with a gap.
struct EndBracket
{
  std::vector<double> closed, /**< of the pressed node */ open; ///< coordinates
};

/// Contact of two sides in the final state. In plane scenes forces are those of a slice of thickness 1.
struct InterfaceSummary
{
  std::string name; ///< of its list in the deck, or as Automatic has named it
  std::string dirichletBody, /**< its outward normal is n_c */ neumannBody; ///< may be rigid, or the same one
  int nodes = 0;                              ///< of the interface: each is one node of either body
  int closedNodes = 0;                        ///< of them
  std::vector<double> forceOnDirichlet;       ///< resultant vector of t_dir on the Dirichlet body
  std::vector<double> forceOnNeumann;         ///< resultant vector of -t_neu on the Neumann body
  double contactForce = 0.0;                  ///< - int t_dir . n_c dS, positive in compression
  bool isArea = false;                        ///< bodies in space touch on areas
  double contactMeasure = 0.0;                ///< sum of int psi_i dS over the closed nodes i: a length or an area
  std::vector<std::vector<double>> endPoints; ///< of the closed nodes: the two farthest apart; in space, of their box
  std::vector<EndBracket> endBrackets;        ///< where contact ends inside the interface (2-D)
  double largestPressure = 0.0;               ///< of the nodes: force over int psi_i dS; 0 if all are open
  double largestPenetration = 0.0;            ///< max (u1_N - u2_N - g) over the nodes, 0 if none
};

/// One sweep of a Neumann-Dirichlet iteration, in the words of the paper; other couplings have one entry.
struct SweepSummary
{
  int sweep = 0;                 ///< from 1
  double epsTau = 0.0;           ///< |Lambda_dir - Lambda_neu| / (1/2 |Lambda_dir + Lambda_neu|): the stopping quantity
  double theta = 0.0;            ///< relaxation factor for the next traction; 0 where there is none
  int statusChanges = 0;         ///< unknowns that opened or closed
  int statusPasses = 0;          ///< linear solves of the status method
  int closed = 0;                ///< unknowns of all interfaces
  int open = 0;                  ///< all others
  double forceOnDirichlet = 0.0; ///< resultants along n_c: int t_dir
  double forceOnNeumann = 0.0;   ///< int t_neu
  double penetration = 0.0;      ///< max (u1_N - u2_N - g) over the unknowns, at least 0: a length
  std::string note;              ///< e.g. "theta clipped"
};

/// How the bodies were brought together.
struct CouplingSummary
{
  std::string type;                  ///< Coupling/Type, or the coupling that Automatic has chosen
  int sweeps = 0;                    ///< entries of `history`
  bool converged = false;            ///< false, too, where a check of the result fails
  std::string reason;                ///< why it stopped, one sentence
  std::vector<SweepSummary> history; ///< the first sweep first; empty when none was finished
  std::vector<RoleSummary> roles;    ///< one per connected part of the network; empty when they were given
};

/// What a stage of the run took.
struct StageSummary
{
  std::string name;           ///< as the ledger calls it, "factor"
  double seconds = 0.0;       ///< wall-clock time of all its passes
  std::int64_t peakBytes = 0; ///< largest resident size while it ran
};

/// An entry of Expect and what came of it.
struct ExpectationSummary
{
  std::string name;       ///< of its list in Expect
  double value = 0.0;     ///< computed
  double expected = 0.0;  ///< in the unit of the quantity
  double tolerance = 0.0; ///< largest |value - expected|
  bool met = false;       ///< within the tolerance; false where the value is NaN: there is no such number
};

/// Everything in NAME.summary.json (docs/summary.schema.json), in the units of the deck.
struct RunSummary
{
  std::string version;             ///< of ndframe
  BuildInfo build;                 ///< of this program
  std::string title;               ///< of the deck
  std::string deckJson;            ///< the effective deck (base/params.hpp: toJson)
  int ranks = 1;                   ///< processes
  bool perUnitThickness = true;    ///< a plane scene: forces and energies are those of a slice of thickness 1
  bool solved = true;              ///< false: the run ended without a solution, whose numbers then are null in the file
  std::vector<BodySummary> bodies; ///< in deck order
  double energy = 0.0;             ///< sum over bodies
  std::vector<InterfaceSummary> interfaces;     ///< in deck order
  std::vector<ProbeSummary> probes;             ///< none: the deck has none
  std::optional<CouplingSummary> coupling;      ///< absent without interfaces
  ResidualSummary residuals;                    ///< zero without a solution
  std::vector<WarningSummary> warnings;         ///< of the scene, then of the answer
  std::optional<ErrorSummary> errors;           ///< absent without Error Estimation
  std::optional<AccuracySummary> accuracy;      ///< absent without Accuracy
  std::vector<ExpectationSummary> expectations; ///< in deck order; none without a solution
  std::map<std::string, std::int64_t> counts;   ///< of the ledger: "factorisations"; what never happened is not in it
  std::vector<StageSummary> stages;             ///< of the ledger
  double totalSeconds = 0.0;                    ///< wall-clock time since the run began
  std::int64_t peakBytes = 0;                   ///< largest resident size of this process
};

} // namespace ndframe
