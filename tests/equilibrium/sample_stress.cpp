#include "sample_stress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "assembly/sample_body.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe::test
{
namespace
{

int strainsOf(int dim)
{
  return dim == 2 ? 3 : 6;
}

int voigtIndex(int dim, int i, int j)
{
  if (i == j)
    return i;
  return dim == 2 ? 2 : (i + j == 1 ? 3 : (i + j == 3 ? 4 : 5));
}

/// Rigid motion m at a point: translations, then rotations in the planes of two axes.
std::vector<double> rigidMotion(int dim, int m, const std::vector<double>& x)
{
  std::vector<double> u(std::size_t(dim), 0.0);
  if (m < dim) {
    u[std::size_t(m)] = 1.0;
    return u;
  }
  const std::size_t planes[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  const auto [i, j] = planes[m - dim];
  u[i] = -x[j];
  u[j] = x[i];
  return u;
}

} // namespace

std::string StressKind::name() const
{
  return fmt::format("dim {}, degree {}", dim, degree);
}

const std::vector<StressKind>& stressKinds()
{
  static const std::vector<StressKind> kinds = {{2, 1}, {2, 2}, {2, 3}, {3, 1}, {3, 2}, {3, 3}};
  return kinds;
}

std::vector<StressKind> recoveredKinds()
{
  std::vector<StressKind> kinds;
  for (const StressKind& kind : stressKinds())
    if (kind.dim == 2 || kind.degree < 3)
      kinds.push_back(kind);
  return kinds;
}

StressField polynomialStress(int dim, int degree, unsigned seed)
{
  // Powers of random affine functions.
  const int terms = 6, strains = strainsOf(dim);
  const std::vector<double> numbers = Random(seed).vector(std::size_t(terms * (strains + dim + 1)));
  return [=](const double* x, double* sigma) {
    std::fill(sigma, sigma + strains, 0.0);
    const double* number = numbers.data();
    for (int term = 0; term < terms; ++term) {
      double affine = *number++;
      for (int i = 0; i < dim; ++i)
        affine += *number++ * x[i];
      for (int s = 0; s < strains; ++s)
        sigma[s] += *number++ * std::pow(affine, degree - term % (degree + 1));
    }
  };
}

ElasticField elasticField(const Elasticity& law, int order, unsigned seed)
{
  const int dim = law.dim;
  const std::vector<double> b = Random(seed).vector(std::size_t(dim * dim));
  std::vector<double> c = Random(seed + 1).vector(std::size_t(dim * dim * dim));
  if (order == 1)
    std::fill(c.begin(), c.end(), 0.0);
  // u_i = b_ij x_j + c_ijk x_j x_k
  const auto displacement = [=](const double* x, double* u) {
    for (int i = 0; i < dim; ++i) {
      u[i] = 0.0;
      for (int j = 0; j < dim; ++j) {
        u[i] += b[std::size_t(i * dim + j)] * x[j];
        for (int k = 0; k < dim; ++k)
          u[i] += c[std::size_t((i * dim + j) * dim + k)] * x[j] * x[k];
      }
    }
  };
  const auto stress = [=](const double* x, double* sigma) {
    std::vector<double> strain(std::size_t(law.strains()), 0.0);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        double gradient = b[std::size_t(i * dim + j)];
        for (int k = 0; k < dim; ++k)
          gradient += (c[std::size_t((i * dim + j) * dim + k)] + c[std::size_t((i * dim + k) * dim + j)]) * x[k];
        strain[std::size_t(voigtIndex(dim, i, j))] += gradient;
      }
    const auto values = test::apply(law, strain);
    std::copy(values.begin(), values.end(), sigma);
  };
  return {displacement, stress};
}

std::vector<double> divergenceOf(const StressField& field, int dim, const double* x)
{
  std::vector<double> divergence(std::size_t(dim), 0.0), point(x, x + dim);
  const double step = 0.5, weights[4] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0};
  const int steps[4] = {-2, -1, 1, 2};
  for (int j = 0; j < dim; ++j)
    for (int s = 0; s < 4; ++s) {
      double sigma[6];
      point[std::size_t(j)] = x[j] + steps[s] * step;
      field(point.data(), sigma);
      point[std::size_t(j)] = x[j];
      for (int i = 0; i < dim; ++i)
        divergence[std::size_t(i)] += weights[s] / step * sigma[voigtIndex(dim, i, j)];
    }
  return divergence;
}

StressCorrection momentsOf(const StressField& field, const Mesh& mesh, int degree)
{
  const int dim = mesh.dim;
  const MomentBasis facet = facetBasis(dim, degree), load = loadBasis(dim, degree);
  StressCorrection result;
  result.dim = dim;
  result.degree = degree;
  std::vector<double> m(std::size_t(facet.size() + load.size()));
  const QuadratureRule rule = simplexRule(dim - 1, 2 * degree);
  for (int c = 0; c < mesh.numCells(); ++c) {
    const SortedCell cell = sortedCell(mesh, c);
    for (int f = 0; f <= dim; ++f) {
      double normal[3], sigma[6];
      const double area = facetNormal(mesh, {c, cell.local[std::size_t(f)]}, normal);
      Vector moments(std::size_t(facet.size() * dim), 0.0);
      for (int q = 0; q < rule.size(); ++q) {
        field(pointOf(mesh, cell, facetPoint(dim, f, rule.point(q)).data()).data(), sigma);
        facet.values(rule.point(q), m.data());
        for (int row = 0; row < facet.size() * dim; ++row)
          for (int j = 0; j < dim; ++j)
            moments[std::size_t(row)] += area * rule.weights[std::size_t(q)] * m[std::size_t(row / dim)] *
                                         sigma[voigtIndex(dim, row % dim, j)] * normal[j];
      }
      result.tractions.insert(result.tractions.end(), moments.begin(), moments.end());
    }
    Vector loads(std::size_t(load.size() * dim), 0.0);
    overSubCells(dim, 2 * degree, [&](int, const double* lambda, double weight) {
      const auto divergence = divergenceOf(field, dim, pointOf(mesh, cell, lambda).data());
      load.values(lambda, m.data());
      for (int row = 0; row < load.size() * dim; ++row)
        loads[std::size_t(row)] +=
            std::abs(cellMeasure(mesh, c)) * weight * m[std::size_t(row / dim)] * divergence[std::size_t(row % dim)];
    });
    result.loads.insert(result.loads.end(), loads.begin(), loads.end());
  }
  return result;
}

Vector workOfUnitMoments(const Mesh& mesh, int degree, const std::function<double(const double*, int)>& displacement)
{
  const int dim = mesh.dim;
  const ReferenceStress& reference = referenceStress(dim, degree);
  const MomentBasis facet = facetBasis(dim, degree), load = loadBasis(dim, degree);
  Vector work(std::size_t(reference.data()), 0.0);
  std::vector<double> m(std::size_t(facet.size() + load.size()));
  const auto add = [&](const MomentBasis& basis, const double* at, const double* lambda, double weight, int first) {
    basis.values(at, m.data());
    for (int row = 0; row < basis.size() * dim; ++row)
      work[std::size_t(first + row)] += weight * m[std::size_t(row / dim)] * displacement(lambda, row % dim);
  };
  const QuadratureRule rule = simplexRule(dim - 1, 2 * degree);
  for (int f = 0; f <= dim; ++f)
    for (int q = 0; q < rule.size(); ++q)
      add(facet, rule.point(q), facetPoint(dim, f, rule.point(q)).data(), rule.weights[std::size_t(q)],
          f * facet.size() * dim);
  overSubCells(dim, 2 * degree, [&](int, const double* lambda, double weight) {
    add(load, lambda, lambda, -weight, reference.tractions);
  });
  return work;
}

double workOf(const StressCorrection& correction, const Mesh& mesh,
              const std::function<double(const double*, int)>& displacement)
{
  Vector data = correction.tractions;
  data.insert(data.end(), correction.loads.begin(), correction.loads.end());
  return dot(data, workOfUnitMoments(mesh, correction.degree, displacement));
}

StressCorrection balancedMoments(const Mesh& cell, int degree, unsigned seed)
{
  const ReferenceStress& reference = referenceStress(cell.dim, degree);
  const SortedCell sorted = sortedCell(cell, 0);
  const int motions = cell.dim == 2 ? 3 : 6;
  DenseMatrix work(reference.data(), motions);
  for (int m = 0; m < motions; ++m) {
    const Vector ofMotion = workOfUnitMoments(cell, degree, [&](const double* lambda, int component) {
      return rigidMotion(cell.dim, m, pointOf(cell, sorted, lambda))[std::size_t(component)];
    });
    std::copy(ofMotion.begin(), ofMotion.end(), work.col(m));
  }
  Vector data = Random(seed).vector(std::size_t(reference.data()));
  // Minus the part that works on rigid motions.
  const Vector imbalance = multiplyTransposed(work, DenseMatrix(data)).column(0);
  const Vector rigid = multiply(work, DenseCholesky(multiplyTransposed(work, work)).solve(imbalance));
  data = difference(std::move(data), rigid);
  StressCorrection result;
  result.dim = cell.dim;
  result.degree = degree;
  result.tractions.assign(data.begin(), data.begin() + reference.tractions);
  result.loads.assign(data.begin() + reference.tractions, data.end());
  return result;
}

Mesh shuffledCell(int dim, unsigned seed)
{
  const Mesh cell = randomCell(dim, seed);
  Mesh shuffled = cell;
  const std::vector<int> number = Random(seed + 100).permutation(dim + 1);
  for (int v = 0; v <= dim; ++v) {
    shuffled.cells[std::size_t(v)] = number[std::size_t(v)];
    std::copy_n(cell.point(v), dim, shuffled.points.begin() + number[std::size_t(v)] * dim);
  }
  return shuffled;
}

BodyModel bodyOf(Mesh mesh, int order, const Elasticity& law)
{
  BodyModel body = makeBody(std::move(mesh), order);
  body.laws = law;
  return body;
}

std::vector<Elasticity> sampleLaws(int dim)
{
  const std::string hypothesis = dim == 2 ? "Plane Strain" : "Three Dimensional";
  return {isotropic(2.0, 0.3, hypothesis), isotropic(3.0, 0.4999, hypothesis),
          material("Orthotropic", woodEntries(dim == 2 ? 30.0 : 0.0), hypothesis)->elasticity()};
}

std::vector<double> pointOf(const Mesh& mesh, const SortedCell& cell, const double* lambda)
{
  std::vector<double> x(std::size_t(mesh.dim), 0.0);
  for (int a = 0; a <= mesh.dim; ++a)
    for (int i = 0; i < mesh.dim; ++i)
      x[std::size_t(i)] += lambda[a] * mesh.point(cell.vertices[std::size_t(a)])[i];
  return x;
}

std::vector<double> facetPoint(int dim, int facet, const double* onFacet)
{
  std::vector<double> lambda(onFacet, onFacet + dim);
  lambda.insert(lambda.begin() + facet, 0.0);
  return lambda;
}

void overSubCells(int dim, int degree, const std::function<void(int, const double*, double)>& visit)
{
  const QuadratureRule rule = simplexRule(dim, degree);
  for (int sub = 0; sub <= dim; ++sub)
    for (int q = 0; q < rule.size(); ++q) {
      std::vector<double> lambda(rule.point(q), rule.point(q) + dim + 1);
      const double ofBarycentre = lambda[std::size_t(sub)] / (dim + 1);
      lambda[std::size_t(sub)] = 0.0;
      for (double& value : lambda)
        value += ofBarycentre;
      visit(sub, lambda.data(), rule.weights[std::size_t(q)] / (dim + 1));
    }
}

double size(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
    sum += std::abs(value);
  return sum;
}

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
  return a;
}

} // namespace ndframe::test
