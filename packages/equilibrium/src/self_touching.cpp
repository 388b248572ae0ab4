#include "ndframe/equilibrium/self_touching.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ndframe/algebra/shared_values.hpp"

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

void refuseTouching(const BodyModel& part, const std::optional<int>& vertex, const Comm& comm)
{
  Vector own;
  if (vertex)
    own.assign(part.mesh.point(*vertex), part.mesh.point(*vertex) + 3);
  const Vector all = gatheredFrom(own, comm);
  std::vector<Direction> places;
  for (std::size_t at = 0; at < all.size(); at += 3)
    places.push_back({all[at], all[at + 1], all[at + 2]});
  if (!places.empty())
    throw SelfTouching(part.name, 3, *std::min_element(places.begin(), places.end()));
}

} // namespace ndframe
