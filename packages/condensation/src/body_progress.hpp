#pragma once

#include <mutex>
#include <vector>

#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// Tells how many bodies are condensed, and what share of the work that is. Where there is one, nothing is known before
/// it is done.
class BodyProgress
{
public:
  /// sizes: dofs of the bodies.
  BodyProgress(const std::vector<int>& sizes, int dim, Ledger& ledger);

  /// Any thread may say so.
  void isDone(std::size_t body);

private:
  void tell() const;

  Ledger& ledger_;
  std::vector<double> work_; ///< operations of a factorisation, but for a factor
  double total_;
  std::mutex mutex_; ///< of what follows
  double done_ = 0.0;
  std::int64_t number_ = 0;
};

} // namespace ndframe
