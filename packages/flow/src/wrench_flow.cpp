#include "ndframe/flow/wrench_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ndframe
{

WrenchFlow::WrenchFlow(std::vector<Direction> centres, std::vector<Link> links)
    : centres_(std::move(centres)), links_(std::move(links)), firstArm_(centres_.size() + 1, 0)
{
  for (const Link& link : links_)
    for (const int node : link.node)
      ++firstArm_[std::size_t(node) + 1];
  std::partial_sum(firstArm_.begin(), firstArm_.end(), firstArm_.begin());
  arms_.resize(2 * links_.size());
  std::vector<int> next(firstArm_.begin(), firstArm_.end() - 1);
  for (int number = 0; number < int(links_.size()); ++number) {
    const auto [a, b] = links_[std::size_t(number)].node;
    arms_[std::size_t(next[std::size_t(a)]++)] = {number, b};
    arms_[std::size_t(next[std::size_t(b)]++)] = {number, a};
  }
  partOf_.assign(centres_.size(), -1);
  for (int node = 0; node < size(); ++node) {
    if (partOf_[std::size_t(node)] >= 0)
      continue;
    partOf_[std::size_t(node)] = numParts();
    std::vector<int> part{node};
    for (std::size_t at = 0; at < part.size(); ++at)
      for (const Arm* arm = begin(part[at]); arm != end(part[at]); ++arm)
        if (partOf_[std::size_t(arm->other)] < 0) {
          partOf_[std::size_t(arm->other)] = numParts();
          part.push_back(arm->other);
        }
    parts_.push_back(std::move(part));
  }
}

/// One flow.
class WrenchFlow::Pass
{
public:
  Pass(const WrenchFlow& flow, std::vector<ForceMoment> lacks)
      : flow_(flow), lacks_(std::move(lacks)), through_(flow.links_.size(), ForceMoment{}),
        set_(flow.centres_.size(), -1)
  {}

  std::vector<ForceMoment> run()
  {
    for (const std::vector<int>& part : flow_.parts_) {
      order_ = part;
      spare_.resize(part.size());
      open_.push_back({0, int(part.size())});
      while (!open_.empty()) {
        const Range range = open_.back();
        open_.pop_back();
        if (range.last - range.first > 1)
          halve(range);
      }
    }
    return std::move(through_);
  }

private:
  /// A link between two sets of a range.
  struct Bridge
  {
    int from, to, link;
  };

  void halve(Range range);
  void sortByPlace(Range range, int middle);
  std::vector<Range> hangingTogether(Range range, int middle);
  std::vector<Bridge> bridges(const std::vector<Range>& sets, int firstSet) const;
  ForceMoment needOf(Range range, const Direction& about) const;
  void spread(const std::vector<int>& links, Range from);
  void send(int link, bool toFirst, const ForceMoment& wrench);

  const WrenchFlow& flow_;
  std::vector<ForceMoment> lacks_, through_;
  std::vector<int> order_, spare_, set_; ///< nodes; per node the set that it was last in
  std::vector<Range> open_;
  int numSets_ = 0;
};

/// A wrench on one of a link's nodes, its opposite on the other.
void WrenchFlow::Pass::send(int number, bool toFirst, const ForceMoment& wrench)
{
  const Link& link = flow_.links_[std::size_t(number)];
  ForceMoment& sum = through_[std::size_t(number)];
  for (std::size_t side = 0; side < 2; ++side) {
    const int node = link.node[side];
    ForceMoment given = wrench;
    if ((side == 0) == toFirst)
      for (double& value : given)
        value = -value;
    addMoved(given, link.spring.centre, flow_.centre(node), lacks_[std::size_t(node)]);
    for (std::size_t i = 0; i < sum.size() && side == 0; ++i)
      sum[i] -= given[i];
  }
}

/// The lower half by place along the longest extent comes first.
void WrenchFlow::Pass::sortByPlace(Range range, int middle)
{
  Direction low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (int at = range.first; at < range.last; ++at)
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = flow_.centre(order_[std::size_t(at)])[i];
      low[i] = std::min(low[i], place);
      high[i] = std::max(high[i], place);
    }
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (high[i] - low[i] > (1.0 + 1e-9) * (high[axis] - low[axis]))
      axis = i;
  const auto begin = order_.begin();
  std::nth_element(begin + range.first, begin + middle, begin + range.last, [&](int a, int b) {
    const double x = flow_.centre(a)[axis], y = flow_.centre(b)[axis];
    return x != y ? x < y : a < b;
  });
}

/// The sets of nodes of both halves that hang together, one after the other; set_ numbers them from numSets_ on.
std::vector<WrenchFlow::Range> WrenchFlow::Pass::hangingTogether(Range range, int middle)
{
  for (int at = range.first; at < range.last; ++at)
    set_[std::size_t(order_[std::size_t(at)])] = at < middle ? -2 : -3;
  std::vector<Range> sets;
  int end = range.first;
  for (int at = range.first; at < range.last; ++at) {
    const int first = order_[std::size_t(at)], half = set_[std::size_t(first)];
    if (half >= 0)
      continue;
    sets.push_back({end, end});
    set_[std::size_t(first)] = numSets_;
    spare_[std::size_t(end++)] = first;
    for (int done = sets.back().first; done < end; ++done)
      for (const Arm *arm = flow_.begin(spare_[std::size_t(done)]), *last = flow_.end(spare_[std::size_t(done)]);
           arm != last; ++arm)
        if (set_[std::size_t(arm->other)] == half) {
          set_[std::size_t(arm->other)] = numSets_;
          spare_[std::size_t(end++)] = arm->other;
        }
    sets.back().last = end;
    ++numSets_;
  }
  std::copy(spare_.begin() + range.first, spare_.begin() + range.last, order_.begin() + range.first);
  return sets;
}

/// All links between the sets, both ways.
std::vector<WrenchFlow::Pass::Bridge> WrenchFlow::Pass::bridges(const std::vector<Range>& sets, int firstSet) const
{
  std::vector<Bridge> result;
  const int end = firstSet + int(sets.size());
  for (int at = sets.front().first; at < sets.back().last; ++at) {
    const int node = order_[std::size_t(at)], own = set_[std::size_t(node)];
    for (const Arm* arm = flow_.begin(node); arm != flow_.end(node); ++arm)
      if (const int set = set_[std::size_t(arm->other)]; set != own && set >= firstSet && set < end)
        result.push_back({own - firstSet, set - firstSet, arm->link});
  }
  return result;
}

void WrenchFlow::Pass::halve(Range range)
{
  const int middle = (range.first + range.last) / 2, firstSet = numSets_;
  sortByPlace(range, middle);
  const std::vector<Range> sets = hangingTogether(range, middle);
  const std::vector<Bridge> all = bridges(sets, firstSet);
  std::vector<int> order{0}, parent(sets.size(), -1); // a tree of sets
  for (std::size_t at = 0; at < order.size(); ++at)
    for (const Bridge& bridge : all)
      if (bridge.to == order[at] && bridge.from != 0 && parent[std::size_t(bridge.from)] < 0) {
        parent[std::size_t(bridge.from)] = bridge.to;
        order.push_back(bridge.from);
      }
  for (std::size_t at = order.size() - 1; at > 0; --at) {
    std::vector<int> links;
    for (const Bridge& bridge : all)
      if (bridge.from == order[at] && bridge.to == parent[std::size_t(bridge.from)])
        links.push_back(bridge.link);
    spread(links, sets[std::size_t(order[at])]);
  }
  open_.insert(open_.end(), sets.begin(), sets.end());
}

ForceMoment WrenchFlow::Pass::needOf(Range range, const Direction& about) const
{
  ForceMoment sum{};
  for (int at = range.first; at < range.last; ++at) {
    const int node = order_[std::size_t(at)];
    addMoved(lacks_[std::size_t(node)], flow_.centre(node), about, sum);
  }
  return sum;
}

void WrenchFlow::Pass::spread(const std::vector<int>& links, Range from)
{
  std::vector<Spring> springs;
  for (const int number : links)
    springs.push_back(flow_.links_[std::size_t(number)].spring);
  const Spring whole = Spring::joined(springs);
  const ForceMoment need = needOf(from, whole.centre);
  const int set = set_[std::size_t(order_[std::size_t(from.first)])];
  for (std::size_t i = 0; i < links.size(); ++i) {
    const int first = flow_.links_[std::size_t(links[i])].node[0];
    send(links[i], set_[std::size_t(first)] == set, whole.shareOf(springs[i], need));
  }
}

std::vector<ForceMoment> WrenchFlow::through(std::vector<ForceMoment> lacks) const
{
  return Pass(*this, std::move(lacks)).run();
}

} // namespace ndframe
