#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/equilibrium/static_data.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "oscillation.hpp"

namespace ndframe
{

namespace
{

constexpr int fieldDegree = 3;

/// Vector polynomials on a cell: an orthonormal scalar basis for every component.
class Fields
{
public:
  explicit Fields(const Mesh& mesh) : mesh_(mesh), dim_(mesh.dim), basis_(MomentBasis::polynomials(dim_, fieldDegree))
  {
    std::vector<double> points;
    for (int v = 0; v <= dim_; ++v)
      points.insert(points.end(), mesh.point(mesh.cell(0)[v]), mesh.point(mesh.cell(0)[v]) + dim_);
    grad_.resize(points.size());
    dim_ == 2 ? barycentricGradients<2>(points.data(), grad_.data())
              : barycentricGradients<3>(points.data(), grad_.data());
  }

  int size() const { return dim_ * basis_.size(); }

  /// All fields at a point of the cell: size x dim.
  std::vector<double> values(const double* lambda) const
  {
    std::vector<double> m(std::size_t(basis_.size())), all(std::size_t(size() * dim_), 0.0);
    basis_.values(lambda, m.data());
    for (int j = 0; j < size(); ++j)
      all[std::size_t(j * dim_ + j % dim_)] = m[std::size_t(j / dim_)];
    return all;
  }

  /// int eps_i : eps_j.
  DenseMatrix strainProducts() const
  {
    const QuadratureRule rule = simplexRule(dim_, 2 * fieldDegree);
    DenseMatrix A(size(), size());
    for (int q = 0; q < rule.size(); ++q) {
      const auto strains = strainsAt(rule.point(q));
      for (int i = 0; i < size(); ++i)
        for (int j = 0; j < size(); ++j)
          for (int k = 0; k < dim_ * dim_; ++k)
            A(i, j) += cellMeasure(mesh_, 0) * rule.weights[std::size_t(q)] *
                       strains[std::size_t(i * dim_ * dim_ + k)] * strains[std::size_t(j * dim_ * dim_ + k)];
    }
    return A;
  }

  /// Tensors (e_kl) of all fields.
  std::vector<double> strainsAt(const double* lambda) const
  {
    std::vector<double> dm(std::size_t(basis_.size() * dim_)), all(std::size_t(size() * dim_ * dim_), 0.0);
    basis_.gradients(lambda, dm.data());
    for (int j = 0; j < size(); ++j)
      for (int l = 0; l < dim_; ++l) {
        double slope = 0.0;
        for (int a = 0; a < dim_; ++a)
          slope += dm[std::size_t(j / dim_ * dim_ + a)] * grad_[std::size_t((a + 1) * dim_ + l)];
        const int k = j % dim_;
        all[std::size_t(j * dim_ * dim_ + k * dim_ + l)] += 0.5 * slope;
        all[std::size_t(j * dim_ * dim_ + l * dim_ + k)] += 0.5 * slope;
      }
    return all;
  }

private:
  const Mesh& mesh_;
  int dim_;
  MomentBasis basis_;
  std::vector<double> grad_;
};

enum class OrthogonalTo
{
  RigidMotions,
  Quadratics
};

/// Columns: the fields that d is orthogonal to.
DenseMatrix fieldsOf(OrthogonalTo kind, int dim, const DenseMatrix& rigid)
{
  if (kind == OrthogonalTo::RigidMotions)
    return rigid;
  DenseMatrix quadratics(rigid.rows(), dim * MomentBasis::polynomials(dim, 2).size()); // the basis begins with them
  for (int j = 0; j < quadratics.cols(); ++j)
    quadratics(j, j) = 1.0;
  return quadratics;
}

/// The largest value of (d, v) / (|d| |eps(v)|) for random d orthogonal to some fields on a set given by points
/// (barycentric in the cell) and weights, and the worst v for each.
double worstRatio(const Mesh& mesh, const QuadratureRule& points, double measure, unsigned seed,
                  OrthogonalTo kind = OrthogonalTo::RigidMotions)
{
  const Fields fields(mesh);
  const int size = fields.size(), dim = mesh.dim;
  DenseMatrix mass(size, size); // of the fields on the set
  for (int q = 0; q < points.size(); ++q) {
    const auto values = fields.values(points.point(q));
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        for (int k = 0; k < dim; ++k)
          mass(i, j) += measure * points.weights[std::size_t(q)] * values[std::size_t(i * dim + k)] *
                        values[std::size_t(j * dim + k)];
  }
  const DenseMatrix A = fields.strainProducts(), inverse = pseudoInverse(A, 1e-10), rigid = nullSpace(A, 1e-10);
  EXPECT_EQ(rigid.cols(), dim == 2 ? 3 : 6);
  const DenseMatrix others = fieldsOf(kind, dim, rigid), massOthers = multiply(mass, others);
  test::Random random(seed);
  double worst = 0.0;
  for (int sample = 0; sample < 10; ++sample) {
    Vector d = random.vector(std::size_t(size));
    const DenseMatrix project = multiplyTransposed(massOthers, DenseMatrix(d));
    const Vector part =
        multiply(others, multiply(pseudoInverse(multiplyTransposed(others, massOthers), 1e-10), project.column(0)));
    for (std::size_t i = 0; i < d.size(); ++i)
      d[i] -= part[i];
    const Vector load = multiply(mass, d);
    worst = std::max(worst, std::sqrt(dot(load, multiply(inverse, load)) / dot(d, load)));
  }
  return worst;
}

/// Points of a facet in the cell's barycentric coordinates.
QuadratureRule onFacet(int dim, int local)
{
  QuadratureRule rule = simplexRule(dim - 1, 2 * fieldDegree), embedded{dim, {}, rule.weights};
  for (int q = 0; q < rule.size(); ++q)
    for (int v = 0, next = 0; v <= dim; ++v)
      embedded.lambda.push_back(v == local ? 0.0 : rule.point(q)[next++]);
  return embedded;
}

void expectConstantsHold(const Mesh& mesh, unsigned seed)
{
  const double inCell = worstRatio(mesh, simplexRule(mesh.dim, 2 * fieldDegree), cellMeasure(mesh, 0), seed);
  EXPECT_LT(inCell, cellOscillationConstant(mesh, 0));
  EXPECT_GT(inCell, 1e-3 * cellOscillationConstant(mesh, 0));
  for (int local = 0; local <= mesh.dim; ++local) {
    double normal[3];
    const double measure = facetNormal(mesh, {0, local}, normal), constant = facetOscillationConstant(mesh, {0, local});
    EXPECT_LT(worstRatio(mesh, onFacet(mesh.dim, local), measure, seed), constant);
    EXPECT_LT(worstRatio(mesh, onFacet(mesh.dim, local), measure, seed, OrthogonalTo::Quadratics),
              constant * shareBeyondPolynomials(mesh.dim, 2));
  }
}

Mesh triangle(std::vector<double> points)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = std::move(points);
  mesh.cells = {0, 1, 2};
  return mesh;
}

/// |A|^2, by LAPACK.
double squaredNorm(const DenseMatrix& A)
{
  return symmetricEigenvalues(multiplyTransposed(A, A)).back();
}

/// |F|^4 |F^-1|^2, the least of all orders of the vertices.
double leastOfAllOrders(const Mesh& mesh)
{
  double points[12], gradients[12], least = HUGE_VAL;
  cellPoints(mesh, 0, points);
  barycentricGradients<3>(points, gradients);
  std::array<int, 4> order{0, 1, 2, 3};
  do {
    DenseMatrix F(3, 3), inverse(3, 3);
    for (int step = 0; step < 3; ++step)
      for (int k = 0; k < 3; ++k) {
        F(k, step) = points[3 * order[std::size_t(step) + 1] + k] - points[3 * order[std::size_t(step)] + k];
        for (std::size_t after = std::size_t(step) + 1; after < 4; ++after)
          inverse(k, step) += gradients[3 * order[after] + k];
      }
    least = std::min(least, std::pow(squaredNorm(F), 2) * squaredNorm(inverse));
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

} // namespace

/// Tetrahedra of any size and shape, the regular ones (double eigenvalues) and slivers of a millionth among them.
TEST(OscillationConstants, OfTetrahedraAreThoseOfTheBestOrderOfTheirVertices)
{
  test::Random random(31);
  for (unsigned seed = 0; seed < 400; ++seed) {
    const double size = std::pow(10.0, 30.0 * random()), thin = std::pow(10.0, -3.0 * (1.0 + random()));
    Mesh mesh = seed % 8 == 0 ? test::box({1, 1, 1}) : test::randomCell(3, seed);
    if (seed % 8 == 4)
      mesh.points = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
    mesh = test::moved(mesh, [&](double* x) {
      for (int k = 0; k < 3; ++k)
        x[k] *= size * (k == 2 && seed % 2 == 1 ? thin : 1.0);
    });
    const double expected = std::sqrt(0.61 * leastOfAllOrders(mesh));
    EXPECT_NEAR(cellOscillationConstant(mesh, 0), expected, 1e-9 * expected) << seed;
  }
}

TEST(OscillationConstants, HoldOnRandomCellsForTheWorstFields)
{
  for (unsigned seed = 0; seed < 12; ++seed)
    expectConstantsHold(test::randomCell(2, seed), seed);
  for (unsigned seed = 0; seed < 3; ++seed)
    expectConstantsHold(test::randomCell(3, seed), seed);
}

TEST(OscillationConstants, HoldOnSlivers)
{
  for (const double thin : {0.3, 0.1, 0.03}) {
    expectConstantsHold(triangle({0, 0, 1, 0, 0.5, thin}), 1);
    expectConstantsHold(triangle({0, 0, 1, 0, 1, thin}), 2);
    expectConstantsHold(triangle({0, 0, 1, 0, 0.2, thin}), 3);
  }
}

TEST(OscillationConstants, AreLengthsAndRootsOfLengths)
{
  const Mesh mesh = test::randomCell(2, 5), large = test::moved(mesh, [](double*x) { x[0] *= 100.0, x[1] *= 100.0; });
  EXPECT_NEAR(cellOscillationConstant(large, 0), 100.0 * cellOscillationConstant(mesh, 0), 1e-10);
  EXPECT_NEAR(facetOscillationConstant(large, {0, 1}), 10.0 * facetOscillationConstant(mesh, {0, 1}), 1e-10);
}

TEST(SmallestStiffness, IsTwiceTheShearModulusOfAnIsotropicSolid)
{
  const double twiceShear = 2.0 / 1.3; // test::elastic: E = 2, nu = 0.3
  EXPECT_NEAR(smallestStiffness(test::elastic(2)), twiceShear, 1e-12);
  EXPECT_NEAR(smallestStiffness(test::elastic(3)), twiceShear, 1e-12);
  EXPECT_LE(smallestStiffness(test::elastic(3)), twiceShear);
}

TEST(SmallestStiffness, BoundsTheEnergyOfEveryStrain)
{
  const double S = 1e-9;
  const Elasticity law = reduceTo(
      Hypothesis::ThreeDimensional,
      rotateAboutZ(*orthotropicStiffness({S, -0.3 * S, -0.1 * S, -0.3 * S, 10 * S, -0.2 * S, -0.1 * S, -0.2 * S, 3 * S},
                                         {0.3 / S, 0.05 / S, 0.7 / S}),
                   0.7));
  const double stiffness = smallestStiffness(law);
  test::Random random(3);
  double least = 1e300;
  for (int sample = 0; sample < 20000; ++sample) {
    Vector strain = random.vector(6);
    double norm2 = 0.0, energy = 0.0;
    for (int i = 0; i < 6; ++i) {
      norm2 += (i < 3 ? 1.0 : 0.5) * strain[std::size_t(i)] * strain[std::size_t(i)];
      for (int j = 0; j < 6; ++j)
        energy += strain[std::size_t(i)] * law(i, j) * strain[std::size_t(j)];
    }
    least = std::min(least, energy / norm2);
  }
  EXPECT_LT(stiffness, least);
  EXPECT_GT(stiffness, 0.5 * least);
}

namespace
{

/// (b - b_h, v) + (p - p_h, v) and |v|^2 on one cell.
struct CellWork
{
  double work = 0.0, energy = 0.0;
};

std::vector<double> pointAt(const Mesh& mesh, const std::vector<int>& vertices, const double* lambda)
{
  std::vector<double> x(2, 0.0);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t k = 0; k < 2; ++k)
      x[k] += lambda[v] * mesh.point(vertices[v])[k];
  return x;
}

/// Moments of q_h from the shares of one simplex.
std::vector<double> summed(const double* shares, std::size_t vertices, std::size_t perVertex)
{
  std::vector<double> sum(perVertex, 0.0);
  for (std::size_t i = 0; i < vertices * perVertex; ++i)
    sum[i % perVertex] += shares[i];
  return sum;
}

double smoothField(const double* x, int k, const Vector& c)
{
  const std::size_t o = std::size_t(k) * 4;
  return c[o] * std::sin(3.0 * x[0] + c[o + 1]) * std::exp(x[1] * c[o + 2]) + c[o + 3] * x[0] * x[1];
}

void smoothGradient(const double* x, int k, const Vector& c, double* g)
{
  const std::size_t o = std::size_t(k) * 4;
  const double e = std::exp(x[1] * c[o + 2]);
  g[0] = 3.0 * c[o] * std::cos(3.0 * x[0] + c[o + 1]) * e + c[o + 3] * x[1];
  g[1] = c[o + 2] * c[o] * std::sin(3.0 * x[0] + c[o + 1]) * e + c[o + 3] * x[0];
}

/// The data: b and, on the edge opposite to vertex 0, p.
void density(const double* x, double* q)
{
  q[0] = std::exp(2.0 * x[0]);
  q[1] = std::sin(4.0 * x[0] * x[1]);
}

/// Adds (q - q_h) . v at a point.
void addWork(const MomentBasis& basis, const std::vector<double>& moments, double measure, const double* lambda,
             const double* x, double weight, const Vector& c, CellWork& sum)
{
  std::vector<double> m(std::size_t(basis.size()));
  basis.values(lambda, m.data());
  double q[2];
  density(x, q);
  for (int k = 0; k < 2; ++k) {
    double rest = q[k];
    for (std::size_t j = 0; j < m.size(); ++j)
      rest -= moments[j * 2 + std::size_t(k)] * m[j] / measure;
    sum.work += weight * rest * smoothField(x, k, c);
  }
}

/// Adds the edge opposite to local vertex 0 (`vertices`: its two, ascending).
void addEdge(const Mesh& mesh, const std::vector<int>& vertices, const MomentBasis& basis,
             const std::vector<double>& moments, const Vector& c, CellWork& sum)
{
  const QuadratureRule rule = simplexRule(1, 30);
  double normal[2];
  const double measure = facetNormal(mesh, {0, 0}, normal);
  for (int q = 0; q < rule.size(); ++q)
    addWork(basis, moments, measure, rule.point(q), pointAt(mesh, vertices, rule.point(q)).data(),
            measure * rule.weights[std::size_t(q)], c, sum);
}

/// Adds the part of one sub-cell (b_h may be constant on each): the cell's vertex `sub` replaced by its centroid.
void addSubCell(const BodyModel& body, const std::vector<int>& vertices, int sub, const MomentBasis& basis,
                const std::vector<double>& moments, const Vector& c, CellWork& sum)
{
  const QuadratureRule rule = simplexRule(2, 14);
  const double measure = cellMeasure(body.mesh, 0);
  for (int q = 0; q < rule.size(); ++q) {
    double lambda[3], g[2][2];
    for (int v = 0; v < 3; ++v)
      lambda[v] = rule.point(q)[sub] / 3.0 + (v == sub ? 0.0 : rule.point(q)[v]);
    const auto x = pointAt(body.mesh, vertices, lambda);
    const double weight = measure / 3.0 * rule.weights[std::size_t(q)];
    addWork(basis, moments, measure, lambda, x.data(), weight, c, sum);
    for (int k = 0; k < 2; ++k)
      smoothGradient(x.data(), k, c, g[k]);
    const double strain[3] = {g[0][0], g[1][1], g[0][1] + g[1][0]};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        sum.energy += weight * strain[i] * body.laws(0)(i, j) * strain[j];
  }
}

} // namespace

TEST(Oscillation, BoundsTheWorkOfWhatTheStressesDoNotCarry)
{
  const std::vector<std::pair<std::string, std::string>> values = {{"X", "exp(2*x)"}, {"Y", "sin(4*x*y)"}};
  auto onEdge = test::onSide("Traction", "edge");
  onEdge.entries.insert(onEdge.entries.end(), values.begin(), values.end());
  test::Random random(11);
  for (const auto& [order, degree] : {std::pair(1, 1), std::pair(1, 2), std::pair(2, 2), std::pair(2, 3)}) {
    double sharpest = 0.0;
    for (unsigned seed = 0; seed < 6; ++seed) {
      Mesh mesh = test::randomCell(2, seed);
      mesh.sides = {{"edge", {{0, 0}}}};
      const BodyModel body = test::makeBody(mesh, order, {{}, {{"Body Force", values}, onEdge}});
      const StaticData data = makeStaticData(body, degree, {});
      const MomentBasis inCell = loadBasis(2, degree), onFacet = facetBasis(2, degree);
      const auto cellMoments = summed(data.cellShares.data(), 3, std::size_t(inCell.size() * 2)),
                 edgeMoments = summed(data.facetShares.data(), 2, std::size_t(onFacet.size() * 2));
      for (int sample = 0; sample < 20; ++sample) {
        const Vector c = random.vector(8);
        CellWork sum;
        addEdge(mesh, {1, 2}, onFacet, edgeMoments, c, sum);
        for (int sub = 0; sub < 3; ++sub)
          addSubCell(body, {0, 1, 2}, sub, inCell, cellMoments, c, sum);
        const double bound = std::sqrt(data.oscillation[0] * sum.energy);
        EXPECT_LE(std::abs(sum.work), bound) << "order " << order << " degree " << degree;
        sharpest = std::max(sharpest, std::abs(sum.work) / bound);
      }
    }
    EXPECT_GT(sharpest, 1e-2);
  }
}

} // namespace ndframe
