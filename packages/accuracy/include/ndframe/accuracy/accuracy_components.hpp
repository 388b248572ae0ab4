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
  Registry<Marking> markings{"marking", "Predicted"};                   ///< which cells become smaller
  Registry<Refinement> refinements{"refinement", "Bisection"};          ///< how the meshes are made
  Registry<ContactTransfer> contactTransfers{"transfer", "Carried"};    ///< what sweeps on the next mesh begin with
  Registry<LevelStopping> levelStoppings{"level stopping", "Balanced"}; ///< when the sweeps on a mesh end
};

} // namespace ndframe
