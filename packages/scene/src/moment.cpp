#include "ndframe/scene/moment.hpp"

namespace ndframe
{

std::vector<double> momentOf(const Direction& arm, const Direction& force, int dim)
{
  const double aboutZ = arm[0] * force[1] - arm[1] * force[0];
  if (dim == 2)
    return {aboutZ};
  return {arm[1] * force[2] - arm[2] * force[1], arm[2] * force[0] - arm[0] * force[2], aboutZ};
}

} // namespace ndframe
