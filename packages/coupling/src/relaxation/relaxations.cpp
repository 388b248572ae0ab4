#include "relaxations.hpp"

namespace ndframe
{

InterfaceValues relax(const InterfaceValues& dirichlet, const InterfaceValues& neumann, double theta)
{
  InterfaceValues next = neumann;
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
