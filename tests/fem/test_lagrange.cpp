#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{

namespace
{

template <int dimension, int degree>
struct Element
{
  static constexpr int dim = dimension, order = degree;
  using Basis = Lagrange<dim, order>;
};

/// Random non-degenerate vertices; in one dimension the segment (0.3, 1.1).
template <int dim>
std::vector<double> randomVertices(unsigned seed)
{
  if constexpr (dim == 1)
    return {0.3, 1.1};
  else
    return test::randomCell(dim, seed).points;
}

template <int dim>
std::vector<double> gradientsOfLambda(const std::vector<double>& vertices)
{
  std::vector<double> g(static_cast<std::size_t>((dim + 1) * dim));
  if constexpr (dim == 1)
    g = {-1.0 / (vertices[1] - vertices[0]), 1.0 / (vertices[1] - vertices[0])};
  else
    barycentricGradients<dim>(vertices.data(), g.data());
  return g;
}

/// Barycentric coordinates of node a.
template <class E>
std::vector<double> nodeLambda(int a)
{
  std::vector<double> lambda(E::dim + 1, 0.0);
  if (a <= E::dim)
    lambda[std::size_t(a)] = 1.0;
  else
    for (const int vertex : SimplexEdges<E::dim>::vertices[std::size_t(a - E::dim - 1)])
      lambda[std::size_t(vertex)] = 0.5;
  return lambda;
}

std::vector<double> randomLambda(int dim, test::Random& random)
{
  std::vector<double> lambda(static_cast<std::size_t>(dim + 1));
  for (double& value : lambda)
    value = random(0.0, 1.0);
  const double sum = std::accumulate(lambda.begin(), lambda.end(), 0.0);
  for (double& value : lambda)
    value /= sum;
  return lambda;
}

template <int dim>
std::vector<double> pointAt(const std::vector<double>& vertices, const std::vector<double>& lambda)
{
  std::vector<double> x(dim, 0.0);
  for (std::size_t v = 0; v <= dim; ++v)
    for (std::size_t k = 0; k < dim; ++k)
      x[k] += lambda[v] * vertices[v * dim + k];
  return x;
}

/// A polynomial with every monomial up to the order of the element, with its gradient.
struct Polynomial
{
  int order;

  double value(const std::vector<double>& x) const
  {
    double linear = 0.7, quadratic = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      linear += (1.0 + double(i)) * x[i];
      for (std::size_t j = 0; j <= i; ++j)
        quadratic += (0.5 + double(i) - 2.0 * double(j)) * x[i] * x[j];
    }
    return order == 1 ? linear : linear + quadratic;
  }
  double slope(std::vector<double> x, std::size_t k) const
  {
    // Central differences are exact for quadratic polynomials.
    const double here = x[k];
    x[k] = here + 1.0;
    const double above = value(x);
    x[k] = here - 1.0;
    return 0.5 * (above - value(x));
  }
};

} // namespace

template <class E>
struct LagrangeElement : testing::Test
{
  test::Random random{7};
  std::vector<double> vertices = randomVertices<E::dim>(3);
  std::vector<double> gradLambda = gradientsOfLambda<E::dim>(vertices);
  double N[E::Basis::nodes]{}, dN[E::Basis::nodes * E::dim]{};
};

using Elements =
    testing::Types<Element<1, 1>, Element<1, 2>, Element<2, 1>, Element<2, 2>, Element<3, 1>, Element<3, 2>>;
TYPED_TEST_SUITE(LagrangeElement, Elements);

TYPED_TEST(LagrangeElement, IsAPartitionOfUnityWithGradientsThatAddUpToZero)
{
  using E = TypeParam;
  for (int sample = 0; sample < 20; ++sample) {
    const auto lambda = randomLambda(E::dim, this->random);
    E::Basis::values(lambda.data(), this->N);
    EXPECT_NEAR(std::accumulate(std::begin(this->N), std::end(this->N), 0.0), 1.0, 1e-14);
    E::Basis::gradients(lambda.data(), this->gradLambda.data(), this->dN);
    for (int k = 0; k < E::dim; ++k) {
      double sum = 0.0;
      for (int a = 0; a < E::Basis::nodes; ++a)
        sum += this->dN[a * E::dim + k];
      EXPECT_NEAR(sum, 0.0, 1e-13);
    }
  }
}

TYPED_TEST(LagrangeElement, IsOneAtItsOwnNodeAndZeroAtTheOthers)
{
  using E = TypeParam;
  for (int node = 0; node < E::Basis::nodes; ++node) {
    E::Basis::values(nodeLambda<E>(node).data(), this->N);
    for (int a = 0; a < E::Basis::nodes; ++a)
      EXPECT_EQ(this->N[a], a == node ? 1.0 : 0.0);
  }
}

TYPED_TEST(LagrangeElement, GradientsAreTheDifferencesOfTheValues)
{
  using E = TypeParam;
  const auto lambda = randomLambda(E::dim, this->random);
  E::Basis::gradients(lambda.data(), this->gradLambda.data(), this->dN);
  for (int k = 0; k < E::dim; ++k) {
    // A step along axis k changes lambda_v by step * gradLambda_vk; differences are exact for quadratics.
    const double step = 0.01;
    auto ahead = lambda, behind = lambda;
    for (std::size_t v = 0; v < lambda.size(); ++v) {
      ahead[v] += step * this->gradLambda[v * E::dim + std::size_t(k)];
      behind[v] -= step * this->gradLambda[v * E::dim + std::size_t(k)];
    }
    double above[E::Basis::nodes], below[E::Basis::nodes];
    E::Basis::values(ahead.data(), above);
    E::Basis::values(behind.data(), below);
    for (int a = 0; a < E::Basis::nodes; ++a)
      EXPECT_NEAR(this->dN[a * E::dim + k], (above[a] - below[a]) / (2.0 * step), 1e-11);
  }
}

TYPED_TEST(LagrangeElement, ReproducesPolynomialsOfItsOrderWithTheirGradients)
{
  using E = TypeParam;
  const Polynomial polynomial{E::order};
  std::vector<double> nodal;
  for (int a = 0; a < E::Basis::nodes; ++a)
    nodal.push_back(polynomial.value(pointAt<E::dim>(this->vertices, nodeLambda<E>(a))));
  for (int sample = 0; sample < 10; ++sample) {
    const auto lambda = randomLambda(E::dim, this->random);
    const auto x = pointAt<E::dim>(this->vertices, lambda);
    E::Basis::values(lambda.data(), this->N);
    E::Basis::gradients(lambda.data(), this->gradLambda.data(), this->dN);
    EXPECT_NEAR(std::inner_product(nodal.begin(), nodal.end(), this->N, 0.0), polynomial.value(x), 1e-13);
    for (std::size_t k = 0; k < E::dim; ++k) {
      double slope = 0.0;
      for (std::size_t a = 0; a < nodal.size(); ++a)
        slope += nodal[a] * this->dN[a * E::dim + k];
      EXPECT_NEAR(slope, polynomial.slope(x, k), 1e-12);
    }
  }
}

template <class Dimension>
struct BarycentricGradients : testing::Test
{};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BarycentricGradients, Dimensions);

TYPED_TEST(BarycentricGradients, TurnEdgesIntoDifferencesOfLambda)
{
  constexpr int dim = TypeParam::value;
  const auto x = randomVertices<dim>(11);
  const auto g = gradientsOfLambda<dim>(x);
  for (int v = 0; v <= dim; ++v)
    for (int a = 0; a <= dim; ++a)
      for (int b = 0; b <= dim; ++b) {
        double change = 0.0;
        for (int k = 0; k < dim; ++k)
          change += g[std::size_t(v * dim + k)] * (x[std::size_t(b * dim + k)] - x[std::size_t(a * dim + k)]);
        EXPECT_NEAR(change, (v == b ? 1.0 : 0.0) - (v == a ? 1.0 : 0.0), 1e-13);
      }
}

TYPED_TEST(BarycentricGradients, ReturnTheMeasureWithTheSignOfTheOrientation)
{
  constexpr int dim = TypeParam::value;
  Mesh cell = test::randomCell(dim, 5);
  double g[(dim + 1) * dim];
  EXPECT_NEAR(barycentricGradients<dim>(cell.points.data(), g), cellMeasure(cell, 0), 1e-15);
  std::swap_ranges(cell.points.begin(), cell.points.begin() + dim, cell.points.begin() + dim);
  EXPECT_NEAR(barycentricGradients<dim>(cell.points.data(), g), cellMeasure(cell, 0), 1e-15);
  EXPECT_LT(cellMeasure(cell, 0), 0.0);
}

TEST(WithDimAndOrder, RunsThePairThatIsAskedForAndRefusesOthers)
{
  const auto code = [](auto d, auto p) { return 10 * d() + p(); };
  for (const int dim : {2, 3})
    for (const int order : {1, 2})
      EXPECT_EQ(withDimAndOrder(dim, order, code), 10 * dim + order);
  EXPECT_THROW(withDimAndOrder(1, 1, code), InternalError);
  EXPECT_THROW(withDimAndOrder(2, 3, code), InternalError);
}

} // namespace ndframe
