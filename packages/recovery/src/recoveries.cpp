#include "automatic_recovery.hpp"
#include "element_recovery.hpp"
#include "global_recovery.hpp"
#include "star_recovery.hpp"

namespace ndframe
{

void registerRecoveries(Registry<StressRecovery>& registry)
{
  registerAutomaticRecovery(registry);
  registerStarRecovery(registry);
  registerElementRecovery(registry);
  registerGlobalRecovery(registry);
}

} // namespace ndframe
