#include "element_recovery.hpp"
#include "star_recovery.hpp"

namespace ndframe
{

void registerRecoveries(Registry<StressRecovery>& registry)
{
  registerStarRecovery(registry);
  registerElementRecovery(registry);
}

} // namespace ndframe
