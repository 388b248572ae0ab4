#pragma once

#include "match_sides.hpp"

namespace ndframe
{

/// Pairs the sides of an interface and appends it to the model, whose bodies and constraints are there. Mistakes are
/// collected or thrown (InputError).
void addInterface(Model& model, const InterfaceSettings& settings, const SidePairing& pairing,
                  const std::vector<InterfaceMesh>& earlier, Diagnostics& diagnostics);

/// A facet touches one other body.
void refuseSharedFacets(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

/// Contact must have something to decide.
void refuseIdleInterfaces(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

} // namespace ndframe
