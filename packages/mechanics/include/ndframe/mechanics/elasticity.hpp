#pragma once

#include <array>
#include <optional>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// How a two-dimensional body is embedded in space.
enum class Hypothesis
{
  PlaneStrain,
  PlaneStress,
  ThreeDimensional
};

/// How a deck calls them.
const Names<Hypothesis>& hypothesisNames();

/// Linear elasticity in Voigt notation with engineering shears: sigma = D eps.
///
/// dim 2: eps = (e_xx, e_yy, 2 e_xy); dim 3: eps = (e_xx, e_yy, e_zz, 2 e_xy, 2 e_yz, 2 e_xz). Unit: a stress.
struct Elasticity
{
  int dim = 0;                        ///< 2 or 3
  std::array<double, 36> D{};         ///< strains() x strains(), row-major, symmetric positive definite
  std::array<double, 3> outOfPlane{}; ///< dim 2: sigma_zz = outOfPlane . eps (zero in plane stress)

  /// Exactly, without a tolerance.
  bool operator==(const Elasticity& other) const
  {
    return dim == other.dim && D == other.D && outOfPlane == other.outOfPlane;
  }

  int strains() const { return dim == 2 ? 3 : 6; } ///< Voigt components
  /// D_ij, a stress.
  double operator()(int i, int j) const { return D[std::size_t(i) * std::size_t(strains()) + std::size_t(j)]; }
};

/// nu of an isotropic law with the same D, lambda / (2 (lambda + mu)), the largest over the planes. Plane stress, where
/// nothing locks, has nu / (1 + nu) < 1/3 there.
double effectivePoisson(const Elasticity& law);

/// Stiffness of the material in space, 6 x 6 row-major in the Voigt order above.
using SpatialStiffness = std::array<double, 36>;

/// Reduces a spatial law to a hypothesis: plane strain drops e_zz = 0, plane stress eliminates e_zz by sigma_zz = 0.
/// Plane hypotheses require that the plane is a plane of symmetry of the material (no coupling with yz, xz).
Elasticity reduceTo(Hypothesis hypothesis, const SpatialStiffness& spatial);

/// The stiffness seen in axes in which the material is turned by `angle` (radians) about z: C' = T C T^T.
SpatialStiffness rotateAboutZ(const SpatialStiffness& spatial, double angle);

/// Stiffness of a material with three planes of symmetry from its normal compliances (3 x 3, row-major, symmetric) and
/// its shear moduli G_xy, G_yz, G_xz. Nothing when the normal compliances are not positive definite beyond round-off.
std::optional<SpatialStiffness> orthotropicStiffness(const std::array<double, 9>& compliance,
                                                     const std::array<double, 3>& shear);

/// The von Mises stress of (xx, yy, zz, xy, yz, xz).
double vonMises(const std::array<double, 6>& stress);

} // namespace ndframe
