#include "recycled_solutions.hpp"

#include <cmath>

namespace ndframe
{

Vector RecycledSolutions::start(const Vector& b) const
{
  Vector x(b.size(), 0.0);
  for (const Vector& known : basis_) {
    const double part = dot(known, b);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += part * known[i];
  }
  return x;
}

void RecycledSolutions::add(const Vector& x, const Vector& Ax)
{
  const double energy = dot(x, Ax);
  if (!(energy > 0.0))
    return; // nothing new
  if (basis_.size() == mostSolutions)
    basis_.clear();
  const double length = std::sqrt(energy);
  basis_.push_back(x);
  for (double& value : basis_.back())
    value /= length;
}

} // namespace ndframe
