#include "body_progress.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ndframe
{
namespace
{

/// Operations of nested dissection are of this order in the number of dofs (George 1973).
double exponent(int dim)
{
  return dim == 2 ? 1.5 : 2.0;
}

} // namespace

BodyProgress::BodyProgress(const std::vector<int>& sizes, int dim, Ledger& ledger) : ledger_(ledger)
{
  for (const int size : sizes)
    work_.push_back(std::pow(double(size), exponent(dim)));
  total_ = std::max(1.0, std::accumulate(work_.begin(), work_.end(), 0.0));
  tell();
}

void BodyProgress::isDone(std::size_t body)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  done_ += work_[body];
  ++number_;
  tell();
}

void BodyProgress::tell() const
{
  const auto count = std::int64_t(work_.size());
  if (count > 1)
    ledger_.tell(Depth::Body, Progress::part("bodies done", number_, count, number_ == count ? 1.0 : done_ / total_));
}

} // namespace ndframe
