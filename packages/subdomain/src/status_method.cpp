#include "ndframe/subdomain/status_method.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double proximalDecay = 1e-1; ///< weight of the proximal term, relative to the stiffness: 0.1, 0.01, ...

std::string joined(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (text.empty() ? "" : ", ") + names[i];
  return names.size() <= most ? text : fmt::format("{} or {} other motions", text, names.size() - most);
}

int countDifferences(const std::vector<char>& a, const std::vector<char>& b)
{
  int n = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    n += a[i] != b[i];
  return n;
}

void solvePass(StatusSystem& system, const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  try {
    system.solve(closed, proximal, pass);
  } catch (const NotPositiveDefinite&) {
    const auto& motions = system.motions();
    throw NotConverged(fmt::format("the closed nodes do not hold the bodies{}: nothing but contact does, and it hardly "
                                   "presses; add a support (a Point if the body is in balance)",
                                   motions.empty() ? "" : " against " + joined(motions)));
  }
}

/// Heads or tails, the same on every machine.
bool tossed(int pass, int condition)
{
  std::uint64_t mixed = (std::uint64_t(pass) << 32U) + std::uint64_t(condition); // the finaliser of splitmix64
  mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
  return ((mixed ^ (mixed >> 31U)) & 1U) != 0;
}

/// Which statuses change after a pass.
class Exchange
{
public:
  /// The history must outlive it.
  Exchange(int draws, StatusHistory& history) : draws_(draws), now_(history) {}
  void look(const std::vector<char>& closed, std::size_t wrong)
  {
    if (now_.single && wrong < now_.fewest) {
      now_.seen.clear();
      now_.single = false;
    }
    if (now_.single || now_.seen.insert(closed).second)
      return;
    now_.cycled = true;
    now_.single = now_.drawn >= draws_;
    now_.fewest = wrong;
  }
  void apply(const std::vector<int>& wrong, std::vector<char>& closed)
  {
    const bool draws = now_.cycled && !now_.single && wrong.size() > 1 && now_.drawn < draws_;
    now_.drawn += draws ? 1 : 0;
    for (const int i : wrong) {
      if (draws && tossed(now_.drawn, i))
        continue;
      closed[std::size_t(i)] = !closed[std::size_t(i)];
      if (now_.single)
        break;
    }
  }

private:
  int draws_; ///< passes that change a half by lot, at most
  StatusHistory& now_;
};

/// Where the passes begin.
StatusPasses firstPass(StatusSystem& system, std::vector<char> closed, Ledger& ledger, const StatusPasses* after)
{
  StatusPasses now;
  if (after == nullptr) {
    now.first = closed;
    now.closed = std::move(closed);
    return now;
  }
  const std::size_t size = closed.size();
  if (after->first.size() != size || after->closed.size() != size || after->u.size() != size ||
      !system.recall(after->system))
    throw InputError("The status passes to go on from are those of another interface or coupling.");
  ledger.restore(after->counts, ledger.stages());
  return *after;
}

UnilateralState settled(StatusPasses now, StatusPass pass, Ledger& ledger)
{
  UnilateralState state;
  state.passes = now.passes;
  state.changes = countDifferences(now.first, now.closed);
  ledger.count("status changes", state.changes);
  state.u = std::move(pass.u);
  state.force = std::move(pass.force);
  state.closed = std::move(now.closed);
  state.cycled = now.history.cycled;
  return state;
}

void keepPass(StatusSystem& system, const StatusPass& pass, const Ledger& ledger, StatusPasses& now,
              const PassesKept& kept)
{
  now.u = pass.u;
  now.system = system.memory();
  now.counts = ledger.counts();
  kept.keep(now);
}

} // namespace

std::vector<int> violations(const StatusPass& pass, const std::vector<char>& constrained, const Vector& bound,
                            const std::vector<char>& closed)
{
  const double noForce = pass.roundOff * std::max(largestEntry(pass.force), pass.load);
  const bool isApart = std::none_of(closed.begin(), closed.end(), [](char status) { return status != 0; });
  const double noGap = isApart ? 0.0 : pass.roundOff * std::max(pass.displacement, largestEntry(bound));
  std::vector<int> wrong;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (constrained[i] && (closed[i] ? pass.force[i] > noForce : pass.u[i] - bound[i] > noGap))
      wrong.push_back(int(i));
  return wrong;
}

UnilateralState findStatuses(StatusSystem& system, const std::vector<char>& constrained, const Vector& bound,
                             std::vector<char> closed, Ledger& ledger, const PassesKept& kept)
{
  const int mostPasses = 100 + 10 * int(closed.size());
  const ProximalLimits limits = system.proximalLimits();
  StatusPasses now = firstPass(system, std::move(closed), ledger, kept.after);
  StatusPass pass;
  pass.u = now.u;
  Exchange exchange(system.mostDraws(), now.history);
  while (now.passes < mostPasses) {
    const bool held = system.holds(now.closed);
    now.proximal = held ? 0 : now.proximal + 1;
    if (now.proximal > limits.passes)
      throw NotConverged(fmt::format("the load does not press the bodies together: contact opens and nothing stops {}",
                                     joined(system.motions())));
    ledger.tell(Depth::Pass, {"status pass", now.passes + 1});
    solvePass(system, now.closed, held ? 0.0 : std::max(limits.weight, std::pow(proximalDecay, now.proximal)), pass);
    ++now.passes;
    ledger.count("status passes");
    const auto wrong = violations(pass, constrained, bound, now.closed);
    const bool isBalanced = held || pass.unbalanced <= pass.roundOff * pass.load;
    if (wrong.empty() && isBalanced)
      return settled(std::move(now), std::move(pass), ledger);
    now.proximal = isBalanced ? 0 : now.proximal;
    if (isBalanced && pass.isFinal)
      exchange.look(now.closed, wrong.size());
    exchange.apply(wrong, now.closed);
    if (kept.keep)
      keepPass(system, pass, ledger, now, kept);
  }
  throw NotConverged(fmt::format("the status method found no consistent set of closed nodes in {} passes{}", mostPasses,
                                 now.history.cycled ? " (it cycled)" : ""));
}

} // namespace ndframe
