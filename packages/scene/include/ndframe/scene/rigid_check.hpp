#pragma once

#include "ndframe/coupling/rigid_network.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The rigid motions that supports leave free and the interface nodes that stop them. Of the nodes of a side with the
/// same normal in the plane only the two outermost: between them rigid motions are linear.
RigidNetwork rigidNetwork(const Model& model);

/// "box along +x, lid turning clockwise about (0, 1)": a motion of rigidNetwork; the first few bodies of many.
std::string motionText(const Model& model, const Vector& motion);

/// Throws NotConverged when the loads pull bodies off, naming the bodies and how they move.
void refusePulledOff(const Model& model);

/// Warns of motions without work that contact lets go on for ever.
void findLooseBodies(const Model& model, const SceneSettings& scene, Diagnostics& found);

} // namespace ndframe
