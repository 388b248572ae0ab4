#include "ndframe/equilibrium/static_data.hpp"

namespace ndframe
{

void BoundaryFacet::removeSupported(int dim, std::size_t count, double* vectors) const
{
  for (std::size_t v = 0; v < count; ++v, vectors += dim)
    for (int s = 0; s < supported; ++s) {
      const double* direction = directions[std::size_t(s)].data();
      double along = 0.0;
      for (int i = 0; i < dim; ++i)
        along += direction[i] * vectors[i];
      for (int i = 0; i < dim; ++i)
        vectors[i] -= along * direction[i];
    }
}

} // namespace ndframe
