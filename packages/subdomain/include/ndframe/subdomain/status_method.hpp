#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// What the status method found.
struct UnilateralState
{
  Vector u;                 ///< normal displacements (all unknowns)
  Vector force;             ///< nodal contact forces r = A u - b: <= 0 where closed, 0 where open or unconstrained
  std::vector<char> closed; ///< per unknown; 0 for unconstrained ones
  int passes = 0;           ///< linear solves
  int changes = 0;          ///< statuses that differ from those at the start
  bool cycled = false;      ///< the simultaneous method came back to an earlier set; finished one node at a time
};

/// Signs and gaps below this, relative to the largest, are zero.
inline constexpr double statusRoundOff = 1e-11;

/// One linear solve of the status method.
struct StatusPass
{
  /// What the bounds are for: displacements or jumps along the normal, a length.
  Vector u, force; ///< per condition
  /// Largest displacement.
  double displacement = 0.0, load = 0.0; ///< the largest: what round-off is compared with
  double roundOff = statusRoundOff;      ///< larger where the solve is not exact
  bool isFinal = true;                   ///< else it stopped early: what its statuses say is a step, and may come back
  /// What the proximal term carries of the load: the largest force.
  double unbalanced = std::numeric_limits<double>::infinity();
};

/// Conditions whose status contradicts the solution: closed ones under tension, open ones that penetrate. Where nothing
/// is closed, penetration has no tolerance: however weakly bodies touch, that they do is tried first.
std::vector<int> violations(const StatusPass& pass, const std::vector<char>& constrained, const Vector& bound,
                            const std::vector<char>& closed);

/// How far passes without enough contact go.
struct ProximalLimits
{
  int passes = 12;       ///< in a row, after which the load counts as pulling bodies off
  double weight = 1e-12; ///< the least of the proximal term, relative to the stiffness
};

/// What a StatusSystem knows of the passes before, but for what it can make again; empty where that means nothing to
/// it.
struct StatusMemory
{
  Vector displacement, force; ///< of the last pass: of all bodies; per condition
  Vector motions;             ///< amplitudes of the free motions in it
  bool isOfForces = false;    ///< bodies are no longer held by the closed conditions alone (NetworkStatuses)
  std::vector<Vector> fields; ///< of whole bodies, in the nodes' own axes
  /// The set that a coarse level of them was made for, and the proximal term.
  std::vector<char> levelClosed;
  double levelProximal = 0.0; ///< relative to the stiffness
  double tolerance = 0.0;     ///< of the next pass
  int earlyPasses = 0;        ///< those that stopped early
};

/// What statuses are found for: conditions u_i <= bound_i that hold as equations where closed.
class StatusSystem
{
public:
  virtual ~StatusSystem() = default;
  /// Whether the closed conditions and supports stop all rigid motions.
  virtual bool holds(const std::vector<char>& closed) = 0;
  /// Solves with the closed conditions as equations. proximal > 0: with the term  proximal |u - u_prev|^2 / 2, relative
  /// to the stiffness; `pass` is the one before (empty at first). Throws NotPositiveDefinite.
  virtual void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) = 0;
  virtual ProximalLimits proximalLimits() const { return {}; } ///< for passes without enough contact
  /// After a set has come back: passes that change a half of what is wrong, by lot, before they change one at a time.
  virtual int mostDraws() const { return 0; }
  /// The rigid motions that supports leave free, for messages.
  virtual const std::vector<std::string>& motions() const = 0;
  /// After a pass. What follows depends on this and on nothing else that came before. Collective.
  virtual StatusMemory memory() { return {}; }
  /// Before the first pass: as after the one that left this. False where it is another system's. Collective.
  virtual bool recall(const StatusMemory& /*memory*/) { return true; }
};

/// Which sets have been seen, and what was done where one came back.
struct StatusHistory
{
  std::set<std::vector<char>> seen; ///< since statuses changed one at a time last
  std::size_t fewest = 0;           ///< wrong statuses of a set that came back
  bool single = false, cycled = false;
  int drawn = 0; ///< passes that changed a half by lot
};

/// Passes that are done. Those that follow have the same bits as if they had followed at once.
struct StatusPasses
{
  std::vector<char> first, closed;            ///< statuses before the first pass, and of the next one
  int passes = 0, proximal = 0;               ///< so far; in a row that needed the proximal term
  Vector u;                                   ///< of the last one
  StatusHistory history;                      ///< of the sets
  StatusMemory system;                        ///< of what was solved
  std::map<std::string, std::int64_t> counts; ///< of the ledger
};

/// Passes that go on from earlier ones, and are kept so that others may go on from them.
struct PassesKept
{
  const StatusPasses* after = nullptr;                ///< null: they begin with the first
  std::function<void(const StatusPasses&)> keep = {}; ///< after every pass that another one follows; empty: never
};

/// The status method: a primal-dual active set. Closed conditions under tension open, open ones that penetrate close,
/// all at once, until nothing changes (Hintermueller, Ito, Kunisch 2002). A set that comes back is a cycle: then only
/// the first violating condition changes (Murty 1974) until fewer are violated than in that set; before that, where the
/// system says so, every other one by lot. A closed set
/// that does not hold the bodies is solved with a vanishing proximal term until contact holds them again, or until the
/// term carries nothing: then the loads do no work on the motions left, and any place will do. Signs and gaps are
/// compared with round-off of the largest force and displacement, so units do not matter; while nothing is closed,
/// every penetration closes.
///
/// constrained: 0 for entries of u without condition. Throws NotConverged when the load does not press the bodies on
/// what holds them (naming the free motions) or after too many passes; InputError where `kept` is of another system.
UnilateralState findStatuses(StatusSystem& system, const std::vector<char>& constrained, const Vector& bound,
                             std::vector<char> closed, Ledger& ledger, const PassesKept& kept = {});

} // namespace ndframe
