#include "ndframe/subdomain/status_method.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
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
  explicit Exchange(int draws) : draws_(draws) {}
  void look(const std::vector<char>& closed, std::size_t wrong)
  {
    if (single_ && wrong < fewest_) {
      seen_.clear();
      single_ = false;
    }
    if (single_ || seen_.insert(closed).second)
      return;
    cycled_ = true;
    single_ = drawn_ >= draws_;
    fewest_ = wrong;
  }
  void apply(const std::vector<int>& wrong, std::vector<char>& closed)
  {
    const bool draws = cycled_ && !single_ && wrong.size() > 1 && drawn_ < draws_;
    drawn_ += draws ? 1 : 0;
    for (const int i : wrong) {
      if (draws && tossed(drawn_, i))
        continue;
      closed[std::size_t(i)] = !closed[std::size_t(i)];
      if (single_)
        break;
    }
  }
  bool cycled() const { return cycled_; }

private:
  std::set<std::vector<char>> seen_;
  std::size_t fewest_ = 0; ///< wrong statuses of a set that came back
  bool single_ = false, cycled_ = false;
  int draws_, drawn_ = 0; ///< passes that change a half by lot: most, so far
};

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
                             std::vector<char> closed, Ledger& ledger)
{
  const std::vector<char> start = closed;
  const int mostPasses = 100 + 10 * int(closed.size());
  const ProximalLimits limits = system.proximalLimits();
  UnilateralState state;
  StatusPass pass;
  Exchange exchange(system.mostDraws());
  for (int proximal = 0; state.passes < mostPasses;) { // proximal: passes in a row that needed the term
    const bool held = system.holds(closed);
    proximal = held ? 0 : proximal + 1;
    if (proximal > limits.passes)
      throw NotConverged(fmt::format("the load does not press the bodies together: contact opens and nothing stops {}",
                                     joined(system.motions())));
    ledger.tell(Depth::Pass, {"status pass", state.passes + 1});
    solvePass(system, closed, held ? 0.0 : std::max(limits.weight, std::pow(proximalDecay, proximal)), pass);
    ++state.passes;
    ledger.count("status passes");
    const auto wrong = violations(pass, constrained, bound, closed);
    const bool isBalanced = held || pass.unbalanced <= pass.roundOff * pass.load;
    if (wrong.empty() && isBalanced) {
      state.changes = countDifferences(start, closed);
      ledger.count("status changes", state.changes);
      state.u = std::move(pass.u);
      state.force = std::move(pass.force);
      state.closed = std::move(closed);
      state.cycled = exchange.cycled();
      return state;
    }
    proximal = isBalanced ? 0 : proximal;
    if (isBalanced && pass.isFinal)
      exchange.look(closed, wrong.size());
    exchange.apply(wrong, closed);
  }
  throw NotConverged(fmt::format("the status method found no consistent set of closed nodes in {} passes{}", mostPasses,
                                 exchange.cycled() ? " (it cycled)" : ""));
}

} // namespace ndframe
