#include <cmath>

#include "materials.hpp"

namespace ndframe
{
namespace
{

/// Orthotropic elasticity with axes 1, 2 turned by `Angle` about z (axis 3 = z).
///
///   eps_i = sigma_i / E_i - sum_j nu_ji sigma_j / E_j,   nu_ij / E_i = nu_ji / E_j,   gamma_ij = sigma_ij / G_ij
///
/// Limits: the compliance must be positive definite (checked, with the place in the deck).
class Orthotropic final : public MaterialLaw
{
public:
  Orthotropic(const SpatialStiffness& stiffness, Hypothesis hypothesis) : stiffness_(stiffness), hypothesis_(hypothesis)
  {}

  Hypothesis hypothesis() const override { return hypothesis_; }
  Elasticity elasticity() const override { return reduceTo(hypothesis_, stiffness_); }

private:
  SpatialStiffness stiffness_;
  Hypothesis hypothesis_;
};

std::unique_ptr<MaterialLaw> buildOrthotropic(const Params& p)
{
  const auto value = [&p](const char* key) { return p.get<double>(key); };
  const double E1 = value("Young Modulus 1"), E2 = value("Young Modulus 2"), E3 = value("Young Modulus 3");
  const double s12 = -value("Poisson Ratio 12") / E1, s13 = -value("Poisson Ratio 13") / E1,
               s23 = -value("Poisson Ratio 23") / E2;
  const auto stiffness =
      orthotropicStiffness({1.0 / E1, s12, s13, s12, 1.0 / E2, s23, s13, s23, 1.0 / E3},
                           {value("Shear Modulus 12"), value("Shear Modulus 23"), value("Shear Modulus 13")});
  if (!stiffness)
    throw InputError(p.mistake("",
                               "the compliance of this material is not positive definite; Poisson ratios must satisfy "
                               "nu_ij^2 < E_i / E_j and leave a positive determinant."));
  return std::make_unique<Orthotropic>(rotateAboutZ(*stiffness, value("Angle") * M_PI / 180.0),
                                       hypothesisNames().value(p.get<std::string>("Hypothesis")));
}

} // namespace

void registerOrthotropic(Registry<MaterialLaw>& registry)
{
  const auto modulus = [](const char* name, const char* doc) {
    return ParamSpec::required(name, Kind::Double, above(0.0), doc);
  };
  const auto ratio = [](const char* name, const char* doc) { return ParamSpec::required(name, Kind::Double, doc); };
  registry.add("Orthotropic", "Three planes of symmetry; axes 1 and 2 in the x-y plane, axis 3 along z.",
               {modulus("Young Modulus 1", "E_1, a stress."), modulus("Young Modulus 2", "E_2, a stress."),
                modulus("Young Modulus 3", "E_3, a stress."),
                ratio("Poisson Ratio 12", "nu_12 = -eps_2 / eps_1 under tension along axis 1."),
                ratio("Poisson Ratio 23", "nu_23 = -eps_3 / eps_2 under tension along axis 2."),
                ratio("Poisson Ratio 13", "nu_13 = -eps_3 / eps_1 under tension along axis 1."),
                modulus("Shear Modulus 12", "G_12, a stress."), modulus("Shear Modulus 23", "G_23, a stress."),
                modulus("Shear Modulus 13", "G_13, a stress."),
                ParamSpec("Angle", 0.0, "Angle from x to axis 1 in degrees, about z."), hypothesisSpec()},
               buildOrthotropic);
}

} // namespace ndframe
