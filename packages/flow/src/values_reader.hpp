#pragma once

#include <cstdint>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{

/// Reads values one after the other, as ranks send them.
class ValuesReader
{
public:
  explicit ValuesReader(const Vector& values) : next_(values.data()), end_(values.data() + values.size()) {}
  explicit operator bool() const { return next_ != end_; }
  double value() { return *next_++; }
  std::int64_t number() { return std::int64_t(value()); }
  Direction direction()
  {
    const Direction result{next_[0], next_[1], next_[2]};
    next_ += 3;
    return result;
  }

private:
  const double *next_, *end_;
};

} // namespace ndframe
