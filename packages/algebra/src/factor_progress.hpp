#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <cholmod.h>

namespace ndframe
{

/// How far a supernodal factorisation by CHOLMOD is, which says nothing itself until it ends.
///
/// CHOLMOD 3 enters three parallel regions for each supernode and two for each pair of a supernode and one that it
/// updates; both numbers, and the operations of each pair, are known from the symbolic factor. So the regions that were
/// entered (SerialOpenMp counts them) tell the supernode it has reached, and the share of the operations before it.
/// Where the library counts differently only the share shown is wrong.
class FactorProgress
{
public:
  /// done, all: operations of all factorisations of this process that run at once.
  using Tell = std::function<void(double done, double all)>;

  /// tell: called when another hundredth is done. symbolic: with int indices.
  FactorProgress(const cholmod_factor& symbolic, Tell tell);
  ~FactorProgress();
  FactorProgress(const FactorProgress&) = delete;
  FactorProgress& operator=(const FactorProgress&) = delete;
  /// CHOLMOD has entered a parallel region.
  void enterRegion()
  {
    if (++regions_ >= next_)
      advance();
  }
  double share() const;                                    ///< of the operations, in [0, 1]
  std::int64_t regions() const { return regions_; }        ///< so far
  std::int64_t expected() const { return before_.back(); } ///< when it ends

private:
  void advance();

  Tell tell_;
  std::vector<std::int64_t> before_; ///< per supernode: regions entered before it; at the end all
  std::vector<double> work_;         ///< likewise: operations
  std::int64_t regions_ = 0, next_ = 0;
  std::size_t reached_ = 0;
  double told_ = 0.0; ///< operations
};

} // namespace ndframe
