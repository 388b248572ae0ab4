#include "ndframe/equilibrium/self_touching.hpp"

#include <fmt/format.h>

namespace ndframe
{

namespace
{

std::string textOf(const std::string& body, int dim, const double* point)
{
  return fmt::format("Bodies/{}: the mesh touches itself at the point {} only: let its cells there share a facet, or "
                     "give each part its own point",
                     body, pointText(point, dim));
}

} // namespace

SelfTouching::SelfTouching(const BodyModel& model, int touching)
    : InputError(textOf(model.name, model.mesh.dim, model.mesh.point(touching))), vertex(touching)
{}

SelfTouching::SelfTouching(const std::string& body, int dim, const Direction& point)
    : InputError(textOf(body, dim, point.data())), vertex(-1)
{}

} // namespace ndframe
