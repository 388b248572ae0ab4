#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace ndframe
{

/// Sets of the numbers 0, 1, ..., at first of one each; each has its smallest as representative.
class JoinedNumbers
{
public:
  explicit JoinedNumbers(int size) : same_(std::size_t(size)) { std::iota(same_.begin(), same_.end(), 0); }

  void join(int first, int second)
  {
    const int a = representative(first), b = representative(second);
    same_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

  /// Per number that of its set, from 0 on, in the order of their smallest.
  std::vector<int> numbered(int& count) &&
  {
    count = 0;
    for (std::size_t v = 0; v < same_.size(); ++v) // a representative is the smallest of its set
      same_[v] = same_[v] == int(v) ? count++ : same_[std::size_t(same_[v])];
    return std::move(same_);
  }

private:
  int representative(int number)
  {
    while (same_[std::size_t(number)] != number)
      number = same_[std::size_t(number)] = same_[std::size_t(same_[std::size_t(number)])];
    return number;
  }

  std::vector<int> same_;
};

} // namespace ndframe
