#pragma once

#include "ndframe/adaptivity/marking.hpp"
#include "ndframe/adaptivity/refinement.hpp"
#include "ndframe/certification/certificate_components.hpp"
#include "ndframe/coupling/level_stopping.hpp"
#include "ndframe/interface/contact_transfer.hpp"

namespace ndframe
{

/// And what a run with a target needs.
struct AccuracyComponents : CertificateComponents
{
  Registry<Marking> markings{"marking", "Predicted"};
  Registry<Refinement> refinements{"refinement", "Bisection"};
  Registry<ContactTransfer> contactTransfers{"transfer", "Carried"};
  Registry<LevelStopping> levelStoppings{"level stopping", "Balanced"};
};

} // namespace ndframe
