#pragma once

#include <exception>
#include <string>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// All rigid motions of the bodies that their supports and the jumps on the interfaces between them leave free:
/// coefficients in the bodies' rigid bases, one body below the other.
DenseMatrix freeTogether(const Model& model);

/// The part of joint motions that moves one body (its rows begin at `offset`), reduced to an orthonormal basis.
DenseMatrix partOf(const DenseMatrix& motions, int offset, int size);

/// Thrown where the outer cells of a body (Model::isOuter) have too few vertices for the pins of a Hold.
class InsideNeeded : public std::exception
{};

/// Gives every support Hold the motions that nothing before it resists, and pins that fix them in the system, one a
/// motion, at nodes without support and contact, of outer cells at vertices, which alone have numbers in the whole. The
/// scene is in equilibrium along these motions, so that the pins carry nothing and any choice of them gives the same
/// stress; loads that are not, and a Hold without a motion, are mistakes.
void resolveHolds(Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

/// The same in a model of shares, which has been told of them.
void takeHolds(Model& model);

/// Moves the bodies by the motions that Holds fix, so that the mean motions held vanish: displacement of every body in
/// global axes. Collective where ranks have shares.
void removeMeanMotions(const Model& model, std::vector<NodalField*> displacement, const Comm& comm);

/// "translation along x"; empty for other supports than Hold.
std::string heldMotions(const Model& model, int body, std::size_t support);

} // namespace ndframe
