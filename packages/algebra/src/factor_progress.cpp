#include "factor_progress.hpp"

#include <limits>
#include <mutex>

namespace ndframe
{
namespace
{

constexpr std::int64_t atFirst = 1, perSupernode = 3, perPair = 2; ///< regions, of t_cholmod_super_numeric.c

/// All that run at once.
struct Running
{
  std::mutex mutex; ///< of what follows
  int number = 0;
  double done = 0.0, all = 0.0;
};

Running& running()
{
  static Running one;
  return one;
}

} // namespace

FactorProgress::FactorProgress(const cholmod_factor& symbolic, Tell tell) : tell_(std::move(tell))
{
  const auto* super = static_cast<const int*>(symbolic.super);
  const auto* first = static_cast<const int*>(symbolic.pi);
  const auto* rows = static_cast<const int*>(symbolic.s);
  std::vector<int> ofColumn(symbolic.n);
  for (std::size_t s = 0; s < symbolic.nsuper; ++s)
    for (int column = super[s]; column < super[s + 1]; ++column)
      ofColumn[std::size_t(column)] = int(s);
  before_.assign(symbolic.nsuper + 1, 0);
  before_[0] = atFirst;
  work_.assign(symbolic.nsuper + 1, 0.0);
  for (std::size_t s = 0; s < symbolic.nsuper; ++s) { // what it costs is kept one place further
    const double columns = super[s + 1] - super[s];
    before_[s + 1] += perSupernode;
    work_[s + 1] += columns * columns * (first[s + 1] - first[s]);
    for (int row = first[s] + int(columns); row < first[s + 1];) {
      const int updated = ofColumn[std::size_t(rows[row])], left = first[s + 1] - row;
      int shared = 0;
      for (; row < first[s + 1] && rows[row] < super[updated + 1]; ++row)
        ++shared;
      before_[std::size_t(updated) + 1] += perPair;
      work_[std::size_t(updated) + 1] += 2.0 * columns * shared * left;
    }
  }
  for (std::size_t s = 0; s < symbolic.nsuper; ++s) {
    before_[s + 1] += before_[s];
    work_[s + 1] += work_[s];
  }
  next_ = before_[1];
  Running& now = running();
  const std::lock_guard<std::mutex> lock(now.mutex);
  ++now.number;
  now.all += work_.back();
}

FactorProgress::~FactorProgress()
{
  Running& now = running();
  const std::lock_guard<std::mutex> lock(now.mutex);
  now.done += work_.back() - told_;
  if (--now.number == 0)
    now.done = now.all = 0.0;
}

double FactorProgress::share() const
{
  return work_[reached_] / work_.back();
}

void FactorProgress::advance()
{
  while (reached_ + 1 < before_.size() && before_[reached_ + 1] <= regions_)
    ++reached_;
  next_ = reached_ + 1 < before_.size() ? before_[reached_ + 1] : std::numeric_limits<std::int64_t>::max();
  if (work_[reached_] < told_ + 0.01 * work_.back())
    return;
  Running& now = running();
  const std::lock_guard<std::mutex> lock(now.mutex);
  now.done += work_[reached_] - told_;
  told_ = work_[reached_];
  tell_(now.done, now.all);
}

} // namespace ndframe
