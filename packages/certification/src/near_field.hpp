#pragma once

#include <optional>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Conjugate gradients with the diagonal D towards K u = load on what is not fixed, from u: until r . D^-1 r <= enough,
/// r the residual, which is about the energy that u lacks where r changes from node to node. For stresses that are
/// brought into balance whatever u lacks of it. Nothing where ten steps are not enough. Of a body that ranks have parts
/// of: values at the nodes of the part, prescribed ones among them; load: complete at own nodes. Collective.
std::optional<Vector> nearField(const BodySystem& system, const Vector& load, Vector u, double enough,
                                const Comm& comm);

/// The same of a body that ranks have parts of, where its own solver does not go on: as many steps as take r . D^-1 r
/// to 1e-8 of `enough`, or very many. Values at the nodes of the part, prescribed ones among them. load: complete at
/// own nodes. Collective.
Vector fieldOfPart(const BodySystem& system, const Vector& load, Vector u, double enough, const Comm& comm);

} // namespace ndframe
