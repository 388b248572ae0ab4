#include "ndframe/drawing/drawn_scene.hpp"

namespace ndframe
{

double dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace ndframe
