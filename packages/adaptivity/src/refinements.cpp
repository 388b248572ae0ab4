#include "refinements.hpp"

namespace ndframe
{

void registerRefinements(Registry<Refinement>& registry)
{
  registerBisection(registry);
  registerRemesh(registry);
}

} // namespace ndframe
