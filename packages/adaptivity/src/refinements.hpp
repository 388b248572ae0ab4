#pragma once

#include "ndframe/adaptivity/refinement.hpp"

namespace ndframe
{

void registerBisection(Registry<Refinement>& registry);
void registerRemesh(Registry<Refinement>& registry);

/// Meshes that are refined by bisection.
std::unique_ptr<RefinedMeshes> bisectedMeshes(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins);

/// The cells themselves.
std::vector<std::vector<int>> ownAncestors(const std::vector<Mesh>& meshes);

} // namespace ndframe
