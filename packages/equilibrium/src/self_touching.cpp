#include "ndframe/equilibrium/self_touching.hpp"

#include <fmt/format.h>

namespace ndframe
{

SelfTouching::SelfTouching(const BodyModel& model, int touching)
    : InputError(fmt::format("Bodies/{}: the mesh touches itself at the point {} only: let its cells there share a "
                             "facet, or give each part its own point",
                             model.name, pointText(model.mesh.point(touching), model.mesh.dim))),
      vertex(touching)
{}

} // namespace ndframe
