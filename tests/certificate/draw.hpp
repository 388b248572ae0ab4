#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace ndframe::test
{

/// Random numbers that are the same with every standard library.
class Draw
{
public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// In [from, to).
  double uniform(double from, double to) { return from + (to - from) * double(engine_() >> 11) * 0x1p-53; }
  /// In [from, to).
  double logarithmic(double from, double to) { return from * std::exp(uniform(0.0, std::log(to / from))); }
  /// From `from` to `to`, both included.
  int integer(int from, int to) { return from + int(uniform(0.0, double(to - from + 1))); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  template <class T>
  const T& pick(const std::vector<T>& list)
  {
    return list[std::size_t(integer(0, int(list.size()) - 1))];
  }

private:
  std::mt19937_64 engine_;
};

} // namespace ndframe::test
