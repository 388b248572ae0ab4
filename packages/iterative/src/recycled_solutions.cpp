#include "recycled_solutions.hpp"

#include <cmath>

namespace ndframe
{

Vector RecycledSolutions::start(const Vector& b) const
{
  Vector x(b.size(), 0.0), parts;
  for (const Vector& known : basis_)
    parts.push_back(dot(known, b));
  comm_.sum(parts);
  for (std::size_t k = 0; k < basis_.size(); ++k)
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += parts[k] * basis_[k][i];
  return x;
}

void RecycledSolutions::add(const Vector& x, const Vector& Ax)
{
  Vector energy{dot(x, Ax)};
  comm_.sum(energy);
  if (!(energy.front() > 0.0))
    return; // nothing new
  if (basis_.size() == mostSolutions)
    basis_.clear();
  const double length = std::sqrt(energy.front());
  basis_.push_back(x);
  for (double& value : basis_.back())
    value /= length;
}

} // namespace ndframe
