#pragma once

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe
{

struct Model;

/// The same traction on the patches of the refined meshes: patch f of `coarse` is divided into the patches f * n ..
/// f * n + n - 1 of `fine`. The division into shares is lost: all of a patch's moments stand with its first vertex.
ContactTraction onFinePatches(const Model& coarseModel, const std::vector<ContactPatch>& coarse,
                              const ContactTraction& traction, const Model& fineModel,
                              const std::vector<ContactPatch>& fine);

} // namespace ndframe
