#include "ndframe/mechanics/elasticity.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{
constexpr int zz = 2;              ///< Voigt place of e_zz in space
constexpr double singular = 1e-12; ///< a relative determinant below this is round-off

double entry(const SpatialStiffness& C, int i, int j)
{
  return C[6 * std::size_t(i) + std::size_t(j)];
}
} // namespace

const Names<Hypothesis>& hypothesisNames()
{
  static const Names<Hypothesis> names{{"Plane Strain", Hypothesis::PlaneStrain},
                                       {"Plane Stress", Hypothesis::PlaneStress},
                                       {"Three Dimensional", Hypothesis::ThreeDimensional}};
  return names;
}

double effectivePoisson(const Elasticity& law)
{
  double largest = 0.0;
  for (int i = 0; i < law.dim; ++i)
    for (int j = 0; j < i; ++j)
      largest = std::max(largest, law(i, j) / (0.5 * (law(i, i) + law(j, j)) + law(i, j)));
  return largest;
}

Elasticity reduceTo(Hypothesis hypothesis, const SpatialStiffness& C)
{
  if (hypothesis == Hypothesis::ThreeDimensional)
    return {3, C, {}};
  constexpr int inPlane[3] = {0, 1, 3};
  Elasticity law{2, {}, {}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double throughThickness = hypothesis == Hypothesis::PlaneStress
                                          ? entry(C, inPlane[i], zz) * entry(C, zz, inPlane[j]) / entry(C, zz, zz)
                                          : 0.0;
      law.D[3 * std::size_t(i) + std::size_t(j)] = entry(C, inPlane[i], inPlane[j]) - throughThickness;
    }
    law.outOfPlane[std::size_t(i)] = hypothesis == Hypothesis::PlaneStrain ? entry(C, zz, inPlane[i]) : 0.0;
  }
  return law;
}

SpatialStiffness rotateAboutZ(const SpatialStiffness& C, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  // Stress transformation of the Voigt vector (xx, yy, zz, xy, yz, xz).
  const double T[6][6] = {{c * c, s * s, 0, -2 * c * s, 0, 0},
                          {s * s, c * c, 0, 2 * c * s, 0, 0},
                          {0, 0, 1, 0, 0, 0},
                          {c * s, -c * s, 0, c * c - s * s, 0, 0},
                          {0, 0, 0, 0, c, s},
                          {0, 0, 0, 0, -s, c}};
  SpatialStiffness turned{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        for (int l = 0; l < 6; ++l)
          turned[6 * std::size_t(i) + std::size_t(j)] += T[i][k] * entry(C, k, l) * T[j][l];
  return turned;
}

std::optional<SpatialStiffness> orthotropicStiffness(const std::array<double, 9>& S, const std::array<double, 3>& shear)
{
  const auto at = [&S](int i, int j) { return S[3 * std::size_t(i % 3) + std::size_t(j % 3)]; };
  const auto cofactor = [&at](int i, int j) {
    return at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1);
  };
  const double det = at(0, 0) * cofactor(0, 0) + at(0, 1) * cofactor(0, 1) + at(0, 2) * cofactor(0, 2);
  const double minor = at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0);
  // The principal minors relative to those of the diagonal, which do not depend on the unit.
  const double area = at(0, 0) * at(1, 1), volume = area * at(2, 2);
  if (!(at(0, 0) > 0.0 && minor > singular * area && det > singular * volume))
    return std::nullopt;
  SpatialStiffness C{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      C[6 * std::size_t(i) + std::size_t(j)] = cofactor(j, i) / det;
    C[7 * std::size_t(i + 3)] = shear[std::size_t(i)];
  }
  return C;
}

double vonMises(const std::array<double, 6>& s)
{
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

} // namespace ndframe
