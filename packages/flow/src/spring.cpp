#include "ndframe/flow/spring.hpp"

namespace ndframe
{
namespace
{

Direction between(const Direction& a, const Direction& b)
{
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

using Symmetric = std::array<double, 6>; // xx, yy, zz, xy, xz, yz

/// x of J x = b.
Direction solved(const Symmetric& J, const double* b)
{
  const double xx = J[1] * J[2] - J[5] * J[5], xy = J[4] * J[5] - J[3] * J[2], xz = J[3] * J[5] - J[4] * J[1],
               yy = J[0] * J[2] - J[4] * J[4], yz = J[3] * J[4] - J[0] * J[5], zz = J[0] * J[1] - J[3] * J[3],
               determinant = J[0] * xx + J[3] * xy + J[4] * xz;
  return {(xx * b[0] + xy * b[1] + xz * b[2]) / determinant, (xy * b[0] + yy * b[1] + yz * b[2]) / determinant,
          (xz * b[0] + yz * b[1] + zz * b[2]) / determinant};
}

/// J b
Direction product(const Symmetric& J, const Direction& b)
{
  return {J[0] * b[0] + J[3] * b[1] + J[4] * b[2], J[3] * b[0] + J[1] * b[1] + J[5] * b[2],
          J[4] * b[0] + J[5] * b[1] + J[2] * b[2]};
}

} // namespace

void addCross(const Direction& arm, const double* force, double factor, double* moment)
{
  moment[0] += factor * (arm[1] * force[2] - arm[2] * force[1]);
  moment[1] += factor * (arm[2] * force[0] - arm[0] * force[2]);
  moment[2] += factor * (arm[0] * force[1] - arm[1] * force[0]);
}

Spring Spring::ofFace(const Direction& centre, double conductance, double size)
{
  const double turning = conductance * size * size;
  return {centre, conductance, {turning, turning, turning, 0.0, 0.0, 0.0}};
}

Spring Spring::joined(const std::vector<Spring>& parts)
{
  Spring whole;
  for (const Spring& part : parts) {
    whole.conductance += part.conductance;
    for (std::size_t i = 0; i < 3; ++i)
      whole.centre[i] += part.conductance * part.centre[i];
  }
  for (double& value : whole.centre)
    value /= whole.conductance;
  for (const Spring& part : parts) {
    const Direction d = between(whole.centre, part.centre);
    const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    for (std::size_t i = 0; i < 3; ++i)
      whole.turning[i] += part.turning[i] + part.conductance * (square - d[i] * d[i]);
    whole.turning[3] += part.turning[3] - part.conductance * d[0] * d[1];
    whole.turning[4] += part.turning[4] - part.conductance * d[0] * d[2];
    whole.turning[5] += part.turning[5] - part.conductance * d[1] * d[2];
  }
  return whole;
}

ForceMoment Spring::shareOf(const Spring& part, const ForceMoment& wrench) const
{
  const Direction b = solved(turning, &wrench[3]), d = between(centre, part.centre), moment = product(part.turning, b);
  ForceMoment share{};
  for (std::size_t i = 0; i < 3; ++i) {
    share[i] = part.conductance / conductance * wrench[i];
    share[3 + i] = moment[i];
  }
  addCross(b, d.data(), part.conductance, share.data());
  return share;
}

void addMoved(const ForceMoment& wrench, const Direction& from, const Direction& to, ForceMoment& sum)
{
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] += wrench[i];
  addCross(between(to, from), wrench.data(), 1.0, &sum[3]);
}

} // namespace ndframe
