#include <gtest/gtest.h>

#include "mechanics/element.hpp"

namespace ndframe
{

template <class E>
struct StressAt : testing::Test
{
  Mesh cell = test::randomCell(E::dim, 31);
  Elasticity law = reduceTo(test::hypothesisOf(E::dim), test::wood(40.0));
};
TYPED_TEST_SUITE(StressAt, test::Elements);

TYPED_TEST(StressAt, IsExactForFieldsOfTheElement)
{
  using E = TypeParam;
  const test::RandomField field(E::dim, 12, E::order == 2);
  const Vector u = E::interpolate(this->cell, field);
  const QuadratureRule rule = simplexRule(E::dim, 4);
  double gradLambda[(E::dim + 1) * E::dim];
  barycentricGradients<E::dim>(this->cell.points.data(), gradLambda);
  for (int q = 0; q < rule.size(); ++q) {
    double strain[6], stress[6], x[3] = {};
    for (int v = 0; v <= E::dim; ++v)
      for (int k = 0; k < E::dim; ++k)
        x[k] += rule.point(q)[v] * this->cell.point(v)[k];
    stressAt<E::dim, E::order>(gradLambda, this->law, rule.point(q), u.data(), strain, stress);
    const auto exactStrain = field.strain(x), exactStress = test::apply(this->law, exactStrain);
    for (std::size_t i = 0; i < E::strains; ++i) {
      EXPECT_NEAR(strain[i], exactStrain[i], 1e-12);
      EXPECT_NEAR(stress[i], exactStress[i], 1e-11);
    }
  }
}

TYPED_TEST(StressAt, AgreesWithTheStressOfTheBasisFunctions)
{
  using E = TypeParam;
  double gradLambda[(E::dim + 1) * E::dim], gradients[E::dofs], centroid[E::dim + 1];
  std::fill_n(centroid, E::dim + 1, 1.0 / (E::dim + 1));
  barycentricGradients<E::dim>(this->cell.points.data(), gradLambda);
  Lagrange<E::dim, E::order>::gradients(centroid, gradLambda, gradients);
  for (int dof = 0; dof < E::dofs; ++dof) {
    Vector u(E::dofs, 0.0);
    u[std::size_t(dof)] = 1.0;
    double strain[6], stress[6], ofBasis[6];
    stressAt<E::dim, E::order>(gradLambda, this->law, centroid, u.data(), strain, stress);
    basisStress<E::dim>(gradients + dof / E::dim * E::dim, dof % E::dim, this->law, ofBasis);
    for (int i = 0; i < E::strains; ++i)
      EXPECT_NEAR(ofBasis[i], stress[i], 1e-12);
  }
}

} // namespace ndframe
