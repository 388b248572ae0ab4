#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "mechanics/element.hpp"

namespace ndframe
{

namespace
{

double largest(const DenseMatrix& A)
{
  double value = 0.0;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i)
      value = std::max(value, std::abs(A(i, j)));
  return value;
}

/// sum_a int_facets N_a . (sigma n) at every node: the forces that hold a constant stress.
template <class E>
Vector boundaryForces(const Mesh& cell, const std::vector<double>& stress)
{
  using Face = Lagrange<E::dim - 1, E::order>;
  const NodeMap nodes = makeNodeMap(cell, E::order);
  const QuadratureRule rule = simplexRule(E::dim - 1, E::order);
  Vector force(E::dofs, 0.0);
  for (int local = 0; local <= E::dim; ++local) {
    double normal[3], traction[3], N[Face::nodes];
    int facet[Face::nodes];
    const double measure = facetNormal(cell, {0, local}, normal);
    facetNodes(nodes, {0, local}, facet);
    divergenceForce<E::dim>(normal, stress.data(), traction);
    for (int q = 0; q < rule.size(); ++q) {
      Face::values(rule.point(q), N);
      for (int a = 0; a < Face::nodes; ++a)
        for (int k = 0; k < E::dim; ++k)
          force[std::size_t(facet[a] * E::dim + k)] += rule.weights[std::size_t(q)] * measure * N[a] * traction[k];
    }
  }
  return force;
}

} // namespace

template <class E>
struct ElementStiffness : testing::Test
{
  static constexpr int rigidMotions = E::dim == 2 ? 3 : 6;
  Mesh cell = test::randomCell(E::dim, 21);
  Elasticity law = reduceTo(test::hypothesisOf(E::dim), test::wood(25.0));
  DenseMatrix K = E::stiffness(cell.points, law);

  double energyOf(const Vector& u) const { return dot(u, multiply(K, u)); }
};
TYPED_TEST_SUITE(ElementStiffness, test::Elements);

TYPED_TEST(ElementStiffness, IsSymmetric)
{
  for (int i = 0; i < this->K.rows(); ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_EQ(this->K(i, j), this->K(j, i));
}

TYPED_TEST(ElementStiffness, AnnulsTheRigidMotionsAndNothingElse)
{
  using E = TypeParam;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Mesh sample = test::randomCell(E::dim, seed);
    const DenseMatrix matrix = E::stiffness(sample.points, this->law);
    EXPECT_EQ(nullSpace(matrix, 1e-10).cols(), this->rigidMotions);
    for (int axis = 0; axis < E::dim; ++axis) {
      const auto translation = E::interpolate(sample, [axis](const double*, double* u) {
        std::fill_n(u, E::dim, 0.0);
        u[axis] = 1.0;
      });
      EXPECT_LT(norm(multiply(matrix, translation)), 1e-13 * largest(matrix));
      for (int other = 0; other < axis; ++other) {
        const auto rotation = E::interpolate(sample, [axis, other](const double* x, double* u) {
          std::fill_n(u, E::dim, 0.0);
          u[axis] = x[other];
          u[other] = -x[axis];
        });
        EXPECT_LT(norm(multiply(matrix, rotation)), 1e-13 * largest(matrix));
      }
    }
  }
}

TYPED_TEST(ElementStiffness, IsPositiveSemiDefinite)
{
  DenseMatrix shifted = this->K;
  for (int i = 0; i < shifted.rows(); ++i)
    shifted(i, i) += 1e-12 * largest(this->K);
  EXPECT_NO_THROW(DenseCholesky(shifted, 0.0));
}

TYPED_TEST(ElementStiffness, TurnsWithElementAndMaterial)
{
  using E = TypeParam;
  const double angle = 0.8;
  const Mesh turnedCell = test::moved(this->cell, [angle](double* x) { test::turn(angle, x); });
  const auto turnedLaw = reduceTo(test::hypothesisOf(E::dim), rotateAboutZ(test::wood(), angle + 25.0 * M_PI / 180.0));
  const DenseMatrix turnedK = E::stiffness(turnedCell.points, turnedLaw);
  Vector u = test::Random(3).vector(E::dofs), force = multiply(this->K, u);
  for (int a = 0; a < E::nodes; ++a) {
    test::turn(angle, u.data() + a * E::dim);
    test::turn(angle, force.data() + a * E::dim);
  }
  const Vector turnedForce = multiply(turnedK, u);
  for (std::size_t i = 0; i < force.size(); ++i)
    EXPECT_NEAR(turnedForce[i], force[i], 1e-12 * largest(this->K));
}

TYPED_TEST(ElementStiffness, ScalesWithStressAndWithLengthToThePowerDimMinusTwo)
{
  using E = TypeParam;
  const double length = 1e3, stress = 1e-9;
  const Mesh scaled = test::moved(this->cell, [length](double* x) {
    for (int k = 0; k < E::dim; ++k)
      x[k] *= length;
  });
  Elasticity scaledLaw = this->law;
  for (double& value : scaledLaw.D)
    value *= stress;
  const DenseMatrix scaledK = E::stiffness(scaled.points, scaledLaw);
  const double factor = stress * (E::dim == 3 ? length : 1.0);
  for (int i = 0; i < E::dofs; ++i)
    for (int j = 0; j < E::dofs; ++j)
      EXPECT_NEAR(scaledK(i, j), factor * this->K(i, j), 1e-13 * factor * largest(this->K));
}

TYPED_TEST(ElementStiffness, AnswersALinearFieldWithTheForcesOfItsStressOnTheFacets)
{
  using E = TypeParam;
  const test::RandomField field(E::dim, 8, false);
  const auto stress = test::apply(this->law, field.strain(this->cell.point(0)));
  const Vector force = multiply(this->K, E::interpolate(this->cell, field));
  const Vector expected = boundaryForces<E>(this->cell, stress);
  for (std::size_t i = 0; i < force.size(); ++i)
    EXPECT_NEAR(force[i], expected[i], 1e-13 * largest(this->K));
}

TYPED_TEST(ElementStiffness, EnergyOfALinearFieldIsStressTimesStrainTimesMeasure)
{
  using E = TypeParam;
  const test::RandomField field(E::dim, 9, false);
  const auto strain = field.strain(this->cell.point(0)), stress = test::apply(this->law, strain);
  const double exact =
      std::inner_product(stress.begin(), stress.end(), strain.begin(), 0.0) * cellMeasure(this->cell, 0);
  EXPECT_NEAR(this->energyOf(E::interpolate(this->cell, field)), exact, 1e-13 * exact);
}

TYPED_TEST(ElementStiffness, EnergyIsExactForFieldsOfItsOrder)
{
  using E = TypeParam;
  // The strain is linear: int e D e = |T| / ((d+1)(d+2)) (sum_v e_v D e_v + (sum_v e_v) D (sum_v e_v)).
  const test::RandomField field(E::dim, 10, E::order == 2);
  const auto work = [this](const std::vector<double>& e) {
    const auto stress = test::apply(this->law, e);
    return std::inner_product(e.begin(), e.end(), stress.begin(), 0.0);
  };
  std::vector<double> sum(E::strains, 0.0);
  double exact = 0.0;
  for (int v = 0; v <= E::dim; ++v) {
    const auto strain = field.strain(this->cell.point(v));
    exact += work(strain);
    std::transform(sum.begin(), sum.end(), strain.begin(), sum.begin(), std::plus<>());
  }
  exact = (exact + work(sum)) * cellMeasure(this->cell, 0) / ((E::dim + 1) * (E::dim + 2));
  EXPECT_NEAR(this->energyOf(E::interpolate(this->cell, field)), exact, 1e-13 * exact);
}

} // namespace ndframe
