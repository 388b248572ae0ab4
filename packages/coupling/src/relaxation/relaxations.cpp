#include "relaxations.hpp"

namespace ndframe
{

Vector relax(const Vector& dirichlet, const Vector& neumann, double theta)
{
  Vector next(neumann.size());
  for (std::size_t i = 0; i < next.size(); ++i)
    next[i] = theta * dirichlet[i] + (1.0 - theta) * neumann[i];
  return next;
}

void registerRelaxations(Registry<RelaxationController>& registry)
{
  registerAutomatic(registry);
  registerConstant(registry);
  registerAitken(registry);
}

} // namespace ndframe
