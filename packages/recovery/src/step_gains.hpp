#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace ndframe
{

/// Which share of itself a bound B falls by in each of the last steps of a descent. Its square falls by known amounts,
/// with conjugate gradients by more and by less from step to step, so the gain is a mean over m steps:
/// 1 - (B_k / B_(k-m))^(1/m).
class StepGains
{
public:
  static constexpr std::size_t together = 4; ///< m; fewer at the beginning

  /// square: B^2 before the first step.
  explicit StepGains(double square) : squares_{square} {}

  /// isStopped: the step could not be as long as it should, which says nothing of those that follow.
  void add(double lowered, bool isStopped = false)
  {
    squares_.push_back(squares_.back() - lowered);
    sinceStopped_ = isStopped ? 0 : sinceStopped_ + 1;
  }
  /// What B^2 has fallen by since the beginning.
  double lowered() const { return squares_.front() - squares_.back(); }
  /// One before the first step, and where B^2 is not known to be above zero.
  double mean() const
  {
    const std::size_t steps = std::min(together, squares_.size() - 1);
    const double before = squares_[squares_.size() - 1 - steps], now = squares_.back();
    return steps > 0 && before > 0.0 && now > 0.0 ? 1.0 - std::pow(now / before, 0.5 / double(steps)) : 1.0;
  }
  /// Whether B^2 is above this, and some more steps with gains like those at present bring it there.
  bool willReach(double square) const
  {
    constexpr double more = 7.0; // gains halve with every fifth step, about: in all they are worth so many
    return squares_.back() > square && squares_.back() * std::pow(1.0 - mean(), 2.0 * more) <= square;
  }
  /// Whether m steps were taken, none of them stopped, and the mean is below this.
  bool areBelow(double least) const { return sinceStopped_ >= together && mean() < least; }

private:
  std::vector<double> squares_;
  std::size_t sinceStopped_ = 0; ///< steps
};

} // namespace ndframe
