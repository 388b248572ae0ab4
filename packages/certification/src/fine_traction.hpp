#pragma once

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe
{

struct Model;

/// The same traction on the facets of the refined meshes: facet f of `coarse` is divided into the facets f * n .. f * n
/// + n - 1 of `fine`. The division into shares is lost: all of a facet's moments stand with its first vertex.
ContactTraction onFineFacets(const Model& coarseModel, const std::vector<ContactFacet>& coarse,
                             const ContactTraction& traction, const Model& fineModel,
                             const std::vector<ContactFacet>& fine);

} // namespace ndframe
