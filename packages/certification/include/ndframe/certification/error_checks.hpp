#pragma once

#include "ndframe/certification/certificate_components.hpp"
#include "ndframe/certification/error_options.hpp"

namespace ndframe
{

/// Refuses what Error Estimation and Output ask for and this deck cannot give: estimators without their inputs, a
/// guarantee from the paper's formula. Looks at the deck only.
void checkErrorEstimation(const Params& deck, Diagnostics& diagnostics);

/// Refuses recoveries that are not defined for bodies of this dimension and order, or that cannot change tractions.
void checkRecovery(const Params& deck, const CertificateComponents& components, int dim, Diagnostics& diagnostics);

} // namespace ndframe
