#include <cmath>

#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/mechanics/cell_laws.hpp"

namespace ndframe
{

namespace
{

using Voigt = std::vector<double>;
using Tensor = std::array<std::array<double, 3>, 3>;

/// Symmetric tensor of a Voigt vector whose shears count `shear` times.
Tensor tensorOf(const Voigt& v, double shear)
{
  return {{{v[0], v[3] / shear, v[5] / shear}, {v[3] / shear, v[1], v[4] / shear}, {v[5] / shear, v[4] / shear, v[2]}}};
}

Voigt voigtOf(const Tensor& t, double shear)
{
  return {t[0][0], t[1][1], t[2][2], shear * t[0][1], shear * t[1][2], shear * t[0][2]};
}

/// R t R^T with R turning by `angle` about z.
Tensor turned(const Tensor& t, double angle)
{
  const double R[3][3] = {{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
  Tensor result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          result[i][j] += R[i][k] * t[k][l] * R[j][l];
  return result;
}

Elasticity spatial(const SpatialStiffness& C)
{
  return reduceTo(Hypothesis::ThreeDimensional, C);
}

template <class A, class B>
void expectNear(const A& a, const B& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << "entry " << i;
}

constexpr double degree = M_PI / 180.0;

} // namespace

TEST(Elasticity, RotationTurnsStressAndStrainAsTensors)
{
  test::Random random(1);
  for (const double angle : {0.3, -1.1, 2.5}) {
    const Voigt strain = random.vector(6);
    const Voigt stress = test::apply(spatial(test::wood()), strain);
    const Voigt turnedStrain = voigtOf(turned(tensorOf(strain, 2.0), angle), 2.0);
    expectNear(test::apply(spatial(rotateAboutZ(test::wood(), angle)), turnedStrain),
               voigtOf(turned(tensorOf(stress, 1.0), angle), 1.0), 1e-13);
  }
}

TEST(Elasticity, RotationByARightAngleSwapsTheAxes)
{
  const SpatialStiffness before = test::wood(), after = rotateAboutZ(before, 90 * degree);
  // Voigt (xx, yy, zz, xy, yz, xz) becomes (yy, xx, zz, xy, xz, yz).
  constexpr int swap[6] = {1, 0, 2, 3, 5, 4};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(after[std::size_t(6 * i + j)], before[std::size_t(6 * swap[i] + swap[j])], 1e-14);
  EXPECT_GT(before[0], 5.0 * after[0]);
}

TEST(Elasticity, FourRightAnglesAreTheIdentity)
{
  SpatialStiffness C = test::wood(17.0);
  for (int turn = 0; turn < 4; ++turn)
    C = rotateAboutZ(C, 90 * degree);
  expectNear(C, test::wood(17.0), 1e-13);
}

TEST(Elasticity, RotationsAddUp)
{
  expectNear(rotateAboutZ(rotateAboutZ(test::wood(), 0.4), -1.3), rotateAboutZ(test::wood(), -0.9), 1e-13);
}

TEST(Elasticity, PlaneStrainIsTheSpatialLawWithoutStrainAcrossThePlane)
{
  const auto C = test::wood(30.0);
  const Elasticity plane = reduceTo(Hypothesis::PlaneStrain, C);
  const Voigt e = test::Random(2).vector(3), stress = test::apply(spatial(C), {e[0], e[1], 0, e[2], 0, 0});
  expectNear(test::apply(plane, e), Voigt{stress[0], stress[1], stress[3]}, 1e-14);
  EXPECT_NEAR(plane.outOfPlane[0] * e[0] + plane.outOfPlane[1] * e[1] + plane.outOfPlane[2] * e[2], stress[2], 1e-14);
}

TEST(Elasticity, PlaneStressLeavesNoStressAcrossThePlane)
{
  const auto C = test::wood(30.0);
  const Elasticity plane = reduceTo(Hypothesis::PlaneStress, C);
  const Voigt e = test::Random(3).vector(3);
  // The strain across the plane that frees the faces.
  const double ezz = -(C[12] * e[0] + C[13] * e[1] + C[15] * e[2]) / C[14];
  const Voigt stress = test::apply(spatial(C), {e[0], e[1], ezz, e[2], 0, 0});
  EXPECT_NEAR(stress[2], 0.0, 1e-14);
  expectNear(test::apply(plane, e), Voigt{stress[0], stress[1], stress[3]}, 1e-14);
  EXPECT_EQ(plane.outOfPlane, (std::array<double, 3>{}));
}

TEST(Elasticity, OrthotropicStiffnessInvertsItsCompliance)
{
  const std::array<double, 9> S = {0.1, -0.04, -0.03, -0.04, 1.2, -0.5, -0.03, -0.5, 2.0};
  const auto C = orthotropicStiffness(S, {3.0, 4.0, 5.0});
  ASSERT_TRUE(C);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double product = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        product += (*C)[6 * i + k] * S[3 * k + j];
      EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-14);
    }
    EXPECT_EQ((*C)[7 * (i + 3)], 3.0 + double(i));
  }
}

TEST(Elasticity, OrthotropicComplianceMustBePositiveDefiniteInAnyUnit)
{
  for (const double unit : {1e-14, 1.0, 1e14}) {
    const auto stiffness = [unit](double s12, double s13, double s23, double s33) {
      std::array<double, 9> S = {1, s12, s13, s12, 1, s23, s13, s23, s33};
      for (double& value : S)
        value *= unit;
      return orthotropicStiffness(S, {1, 1, 1});
    };
    EXPECT_TRUE(stiffness(0, 0, 0, 1));
    EXPECT_TRUE(stiffness(-0.49, -0.49, -0.49, 1));
    EXPECT_FALSE(stiffness(-0.5, -0.5, -0.5, 1)) << "incompressible";
    EXPECT_FALSE(stiffness(1, 0, 0, 1));
    EXPECT_FALSE(stiffness(1.1, 0, 0, 1));
    EXPECT_FALSE(stiffness(0, 0.9, 0.9, 1));
    EXPECT_FALSE(stiffness(0, 0, 0, -1));
  }
}

TEST(Elasticity, VonMisesOfKnownStates)
{
  EXPECT_DOUBLE_EQ(vonMises({-3, 0, 0, 0, 0, 0}), 3.0);
  EXPECT_DOUBLE_EQ(vonMises({5, 5, 5, 0, 0, 0}), 0.0);
  for (std::size_t shear = 3; shear < 6; ++shear) {
    std::array<double, 6> stress{};
    stress[shear] = 2.0;
    EXPECT_DOUBLE_EQ(vonMises(stress), 2.0 * std::sqrt(3.0));
  }
  EXPECT_DOUBLE_EQ(vonMises({4, 4, 0, 0, 0, 0}), 4.0);
  EXPECT_DOUBLE_EQ(vonMises({1, -1, 0, 0, 0, 0}), vonMises({0, 0, 0, 1, 0, 0}));
}

TEST(Elasticity, VonMisesDoesNotFeelPressureNorRotation)
{
  const Voigt s = test::Random(4).vector(6), t = voigtOf(turned(tensorOf(s, 1.0), 0.7), 1.0);
  const double value = vonMises({s[0], s[1], s[2], s[3], s[4], s[5]});
  EXPECT_NEAR(vonMises({s[0] + 2, s[1] + 2, s[2] + 2, s[3], s[4], s[5]}), value, 1e-14);
  EXPECT_NEAR(vonMises({t[0], t[1], t[2], t[3], t[4], t[5]}), value, 1e-14);
}

TEST(CellLaws, AreNumberedAlikeWhateverCellsThereAre)
{
  const Elasticity soft = test::isotropic(1.0, 0.3), hard = test::isotropic(9.0, 0.3);
  const std::vector<Elasticity> laws{soft, hard, soft};
  const CellLaws whole(laws, {2, 1, 0}), part(laws, {1}), nothing(laws, {});
  for (const CellLaws* all : {&whole, &part, &nothing}) {
    EXPECT_EQ(all->all().size(), 2U);
    EXPECT_EQ(all->numberOf(soft), 0);
    EXPECT_EQ(all->numberOf(hard), 1);
  }
  EXPECT_EQ(whole.number(0), 0);
  EXPECT_TRUE(part(0) == hard);
  EXPECT_TRUE(CellLaws({soft, soft}, {0, 1, 0}).isUniform());
}

} // namespace ndframe
