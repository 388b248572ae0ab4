#include "doubt.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{

void Doubt::add(const Samples& samples, const Mesh& mesh, int dim, const int* vertices)
{
  if (samples.areCertain() || samples.uncertainty <= uncertainty)
    return;
  uncertainty = samples.uncertainty;
  double centroid[3] = {};
  for (int v = 0; v <= dim; ++v)
    for (int k = 0; k < mesh.dim; ++k)
      centroid[k] += mesh.point(vertices[v])[k] / (dim + 1);
  place = pointText(centroid, mesh.dim);
}

std::string Doubt::size() const
{
  return std::isfinite(uncertainty) ? fmt::format("to {:.1g} of its largest value", uncertainty)
                                    : "it cannot be bounded there";
}

} // namespace ndframe
