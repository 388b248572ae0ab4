#include "ndframe/run/accuracy_summary.hpp"

namespace ndframe
{

int AccuracySummary::sweeps() const
{
  int sum = 0;
  for (const auto& level : levels)
    sum += level.sweeps;
  return sum;
}

std::int64_t AccuracySummary::totalDofs() const
{
  std::int64_t sum = 0;
  for (const auto& level : levels)
    sum += level.dofs;
  return sum;
}

} // namespace ndframe
