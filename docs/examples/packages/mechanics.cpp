// Reduces an isotropic material to plane stress and pulls a triangle: the stress is Young's modulus times the strain.
#include <cmath>

#include "ndframe/mechanics/kernels.hpp"

int main()
{
  using namespace ndframe;
  const double E = 210.0, nu = 0.3, G = E / (2.0 * (1.0 + nu));
  const auto stiffness = orthotropicStiffness(
      {1.0 / E, -nu / E, -nu / E, -nu / E, 1.0 / E, -nu / E, -nu / E, -nu / E, 1.0 / E}, {G, G, G});
  const Elasticity law = reduceTo(Hypothesis::PlaneStress, *stiffness);

  // u = (0.01 x, -nu 0.01 y) is tension along x, free along y.
  const double points[6] = {0, 0, 2, 0, 0, 1}, lambda[3] = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
  const double u[6] = {0, 0, 0.02, 0, 0, -0.01 * nu};
  double strain[3], stress[3], K[36], work = 0.0;
  double gradients[6];
  barycentricGradients<2>(points, gradients);
  stressAt<2, 1>(gradients, law, lambda, u, strain, stress);
  elementStiffness<2, 1>(points, law, simplexRule(2, 0), K);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      work += u[i] * K[6 * i + j] * u[j];

  const double tension = 0.01 * E, area = 1.0;
  const bool isTension = std::abs(stress[0] - tension) + std::abs(stress[1]) + std::abs(stress[2]) < 1e-14 * E;
  const bool isEquivalent = std::abs(vonMises({stress[0], stress[1], 0.0, stress[2], 0.0, 0.0}) - tension) < 1e-14 * E;
  return isTension && isEquivalent && std::abs(work - area * tension * 0.01) < 1e-14 * E ? 0 : 1;
}
