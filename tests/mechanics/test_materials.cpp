#include <cmath>

#include <gmock/gmock.h>

#include "fem/sample_meshes.hpp"
#include "mechanics/sample_laws.hpp"

namespace ndframe
{

namespace
{

using test::complaint;
using testing::AllOf;
using testing::HasSubstr;

constexpr double E = 2.1, nu = 0.3;

void expectStress(const Elasticity& law, const std::vector<double>& strain, const std::vector<double>& stress)
{
  const auto computed = test::apply(law, strain);
  for (std::size_t i = 0; i < stress.size(); ++i)
    EXPECT_NEAR(computed[i], stress[i], 1e-14);
}

/// The isotropic material written with orthotropic constants.
test::Entries isotropicAsOrthotropic(double angle)
{
  const double G = E / (2.0 * (1.0 + nu));
  return {{"Young Modulus 1", E},   {"Young Modulus 2", E},   {"Young Modulus 3", E},  {"Poisson Ratio 12", nu},
          {"Poisson Ratio 23", nu}, {"Poisson Ratio 13", nu}, {"Shear Modulus 12", G}, {"Shear Modulus 23", G},
          {"Shear Modulus 13", G},  {"Angle", angle}};
}

std::string isotropicComplaint(double young, double poisson)
{
  return complaint("Isotropic", {{"Young Modulus", young}, {"Poisson Ratio", poisson}});
}

} // namespace

TEST(Isotropic, TensionStretchesByOneOverEAndNarrowsByNuOverE)
{
  expectStress(test::isotropic(E, nu, "Three Dimensional"), {1 / E, -nu / E, -nu / E, 0, 0, 0}, {1, 0, 0, 0, 0, 0});
  expectStress(test::isotropic(E, nu, "Plane Stress"), {1 / E, -nu / E, 0}, {1, 0, 0});
  expectStress(test::isotropic(E, nu, "Plane Strain"), {(1 - nu * nu) / E, -nu * (1 + nu) / E, 0}, {1, 0, 0});
}

TEST(Isotropic, ShearsByOneOverG)
{
  const double compliance = 2.0 * (1.0 + nu) / E;
  for (const char* hypothesis : {"Plane Strain", "Plane Stress"})
    expectStress(test::isotropic(E, nu, hypothesis), {0, 0, compliance}, {0, 0, 1});
  for (std::size_t shear = 3; shear < 6; ++shear) {
    std::vector<double> strain(6, 0.0), stress(6, 0.0);
    strain[shear] = compliance;
    stress[shear] = 1.0;
    expectStress(test::isotropic(E, nu, "Three Dimensional"), strain, stress);
  }
}

TEST(Isotropic, PlaneStrainIsHeldAcrossThePlaneByNuTimesTheTrace)
{
  const Elasticity law = test::isotropic(E, nu, "Plane Strain");
  const auto strain = test::Random(5).vector(3), stress = test::apply(law, strain);
  double across = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    across += law.outOfPlane[i] * strain[i];
  EXPECT_NEAR(across, nu * (stress[0] + stress[1]), 1e-15);
}

TEST(Isotropic, ParametersOutOfRangeAreRefusedByName)
{
  EXPECT_EQ(isotropicComplaint(1.0, 0.499), "");
  EXPECT_EQ(isotropicComplaint(1.0, -0.999), "");
  for (const double poisson : {0.5, -1.0, 0.7})
    EXPECT_THAT(isotropicComplaint(1.0, poisson), AllOf(HasSubstr("Poisson Ratio"), HasSubstr("(-1, 0.5)")));
  for (const double young : {0.0, -1.0})
    EXPECT_THAT(isotropicComplaint(young, 0.3), AllOf(HasSubstr("Young Modulus"), HasSubstr("> 0")));
}

TEST(Isotropic, NeedsBothConstants)
{
  EXPECT_THAT(complaint("Isotropic", {}), AllOf(HasSubstr("Young Modulus"), HasSubstr("Poisson Ratio")));
}

TEST(Orthotropic, WithEqualConstantsIsIsotropicAtAnyAngle)
{
  for (const char* hypothesis : {"Plane Strain", "Plane Stress", "Three Dimensional"})
    for (const double angle : {0.0, 30.0}) {
      const auto orthotropic = test::material("Orthotropic", isotropicAsOrthotropic(angle), hypothesis)->elasticity();
      const auto isotropic = test::isotropic(E, nu, hypothesis);
      EXPECT_EQ(orthotropic.dim, isotropic.dim);
      for (std::size_t i = 0; i < 36; ++i)
        EXPECT_NEAR(orthotropic.D[i], isotropic.D[i], 1e-14);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(orthotropic.outOfPlane[i], isotropic.outOfPlane[i], 1e-14);
    }
}

TEST(Orthotropic, PoissonRatiosSayHowTensionAlongTheFirstIndexNarrowsTheSecond)
{
  const Elasticity law{3, test::wood(), {}};
  expectStress(law, {0.1, -0.04, -0.035, 0, 0, 0}, {1, 0, 0, 0, 0, 0});
  // nu_21 = nu_12 E_2 / E_1
  expectStress(law, {-0.04, 1.25, -0.45 / 0.8, 0, 0, 0}, {0, 1, 0, 0, 0, 0});
  expectStress(law, {0, 0, 0, 1 / 0.7, 1 / 0.1, 1 / 0.6}, {0, 0, 0, 1, 1, 1});
}

TEST(Orthotropic, AngleTurnsAxisOneFromXTowardsY)
{
  const SpatialStiffness straight = test::wood(0.0), upright = test::wood(90.0);
  EXPECT_NEAR(upright[7], straight[0], 1e-13);
  // At 45 degrees tension along x = y is tension along axis 1; at -45 degrees it is not.
  const std::vector<double> diagonal = {0.5, 0.5, 0, 1, 0, 0};
  const auto along = test::apply({3, test::wood(45.0), {}}, diagonal);
  const auto across = test::apply({3, test::wood(-45.0), {}}, diagonal);
  EXPECT_GT(along[3], 5.0 * across[3]);
}

TEST(Orthotropic, MaterialThatIsNotPositiveDefiniteIsRefused)
{
  for (const double unit : {1e-9, 1.0, 1e12}) {
    const auto wood = test::woodEntries(0.0, unit);
    EXPECT_EQ(complaint("Orthotropic", wood), "");
    // nu_12^2 < E_1 / E_2 = 12.5
    EXPECT_THAT(complaint("Orthotropic", test::with(wood, "Poisson Ratio 12", 3.6)),
                AllOf(HasSubstr("material.xml"), HasSubstr("not positive definite"), HasSubstr("nu_ij^2 < E_i / E_j")));
    EXPECT_THAT(complaint("Orthotropic", test::with(wood, "Poisson Ratio 23", 1.3)),
                HasSubstr("not positive definite"));
  }
}

TEST(Orthotropic, ModuliMustBePositive)
{
  for (const char* key : {"Young Modulus 1", "Young Modulus 2", "Young Modulus 3", "Shear Modulus 12",
                          "Shear Modulus 23", "Shear Modulus 13"})
    EXPECT_THAT(complaint("Orthotropic", test::with(test::woodEntries(), key, 0.0)),
                AllOf(HasSubstr(key), HasSubstr("> 0")));
}

TEST(Materials, SayTheirHypothesis)
{
  for (const char* hypothesis : {"Plane Strain", "Plane Stress", "Three Dimensional"}) {
    const auto isotropic =
        test::material("Isotropic", {{"Young Modulus", E}, {"Poisson Ratio", nu}}, hypothesis)->hypothesis();
    EXPECT_EQ(hypothesisNames().name(isotropic), hypothesis);
    EXPECT_EQ(test::material("Orthotropic", test::woodEntries(), hypothesis)->hypothesis(), isotropic);
  }
}

} // namespace ndframe
