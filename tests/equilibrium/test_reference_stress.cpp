#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "equilibrium/sample_stress.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/cell_forms.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

using test::StressKind;

/// c alone: the displacement is zero.
SplitStress stressOf(const Mesh& mesh, const StressCorrection& correction)
{
  const BodyModel body = test::bodyOf(mesh, 1, test::sampleLaws(mesh.dim)[0]);
  return equilibratedStress(body, Vector(std::size_t(body.numDofs()), 0.0), correction, 0);
}

/// The polynomial with the given moments: dim values at a point.
std::vector<double> fieldOf(const MomentBasis& basis, const double* point, const double* moments, int dim,
                            double measure)
{
  std::vector<double> m(std::size_t(basis.size())), value(std::size_t(dim), 0.0);
  basis.values(point, m.data());
  for (int row = 0; row < basis.size() * dim; ++row)
    value[std::size_t(row % dim)] += moments[row] * m[std::size_t(row / dim)] / measure;
  return value;
}

std::vector<double> tractionOf(const SplitStress& stress, int sub, const double* lambda, const double* normal)
{
  double s[6];
  stress.stress(sub, lambda, s);
  if (stress.dim == 2)
    return {s[0] * normal[0] + s[2] * normal[1], s[2] * normal[0] + s[1] * normal[1]};
  return {s[0] * normal[0] + s[3] * normal[1] + s[5] * normal[2],
          s[3] * normal[0] + s[1] * normal[1] + s[4] * normal[2],
          s[5] * normal[0] + s[4] * normal[1] + s[2] * normal[2]};
}

/// The reference simplex itself.
Mesh referenceCell(int dim)
{
  return dim == 2 ? Mesh{2, {0, 0, 1, 0, 0, 1}, {0, 1, 2}, {}, {}}
                  : Mesh{3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3}, {}, {}};
}

/// A stress on the reference simplex by coefficients.
SplitStress referenceField(const StressKind& kind, std::vector<double> coefficients)
{
  const Mesh mesh = referenceCell(kind.dim);
  SplitStress stress;
  stress.dim = kind.dim;
  stress.degree = kind.degree;
  stress.cell = sortedCell(mesh, 0);
  stress.map = cellMap(mesh, stress.cell);
  stress.coefficients = std::move(coefficients);
  return stress;
}

/// A normal of the inner facet between two sub-cells: it holds the barycentre and the vertices that both have.
std::vector<double> innerNormal(const Mesh& mesh, const SortedCell& cell, int i, int j)
{
  const double n = mesh.dim + 1.0;
  std::vector<std::vector<double>> corners = {test::pointOf(mesh, cell, std::vector<double>(4, 1.0 / n).data())};
  for (int a = 0; a <= mesh.dim; ++a)
    if (a != i && a != j) {
      std::vector<double> vertex(4, 0.0);
      vertex[std::size_t(a)] = 1.0;
      corners.push_back(test::difference(test::pointOf(mesh, cell, vertex.data()), corners[0]));
    }
  const auto& u = corners[1];
  if (mesh.dim == 2)
    return {-u[1], u[0]};
  const auto& v = corners[2];
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

} // namespace

TEST(ReferenceStress, HasTheNumbersOfTheTheory)
{
  const int expected[][5] = {{2, 3, 12, 6, 0},  {3, 3, 18, 6, 3},   {4, 6, 24, 12, 9},
                             {3, 4, 36, 12, 0}, {6, 4, 72, 12, 18}, {10, 10, 120, 30, 66}};
  for (std::size_t i = 0; i < test::stressKinds().size(); ++i) {
    const auto& [dim, degree] = test::stressKinds()[i];
    const ReferenceStress& tables = referenceStress(dim, degree);
    EXPECT_EQ(tables.facetModes, expected[i][0]);
    EXPECT_EQ(tables.loadModes, expected[i][1]);
    EXPECT_EQ(tables.tractions, expected[i][2]);
    EXPECT_EQ(tables.loads, expected[i][3]);
    EXPECT_EQ(tables.bubbles, expected[i][4]);
    EXPECT_EQ(tables.energy.size(), dim == 2 ? 6u : 21u);
    EXPECT_EQ(tables.energy[0].cols(), tables.data() + tables.bubbles);
    EXPECT_EQ(tables.coefficients, tables.lift.rows());
  }
}

namespace
{

/// Of cells side by side: parts of these matrices.
void expectFacets(const ReferenceStress& reference, const CellForms::Facets& found,
                  const std::vector<DenseMatrix>& expected)
{
  const int of = reference.tractions / 4, linear = CellForms::linear;
  const auto expectEntry = [&](const double* entry, int i, int j) {
    for (std::size_t lane = 0; lane < expected.size(); ++lane) {
      const DenseMatrix& A = expected[lane];
      EXPECT_NEAR(entry[lane], A(i, j), 1e-10 * std::sqrt(A(i, i) * A(j, j))) << i << ", " << j;
    }
  };
  const double *alone = found.alone, *pairs = found.pairs;
  for (int f = 0; f < 4; ++f) {
    for (int j = 0; j < of; ++j)
      for (int i = j; i < of; ++i, alone += CellForms::lanes)
        expectEntry(alone, f * of + i, f * of + j);
    for (int g = f + 1; g < 4; ++g)
      for (int j = 0; j < linear; ++j)
        for (int i = 0; i < linear; ++i, pairs += CellForms::lanes)
          expectEntry(pairs, g * of + i, f * of + j);
  }
}

} // namespace

TEST(ReferenceStress, ManyCellsSideBySideHaveTheMatricesOfEach)
{
  for (const int degree : {1, 2}) {
    const ReferenceStress& reference = referenceStress(3, degree);
    const Elasticity law = test::sampleLaws(3)[0];
    test::Random random(3);
    std::vector<DenseMatrix> expected;
    Vector compliances(reference.energy.size() * CellForms::lanes), work;
    for (std::size_t lane = 0; lane < CellForms::lanes; ++lane) {
      Mesh mesh = referenceCell(3);
      const Vector moves = random.vector(mesh.points.size());
      for (std::size_t i = 0; i < moves.size(); ++i)
        mesh.points[i] = (mesh.points[i] + 0.1 * moves[i]) * (i % 3 == 2 && lane % 2 == 1 ? 0.01 : 1.0); // slivers, too
      const CellMap map = cellMap(mesh, sortedCell(mesh, 0));
      expected.push_back(CellForm(reference, map, law).condensed());
      const auto own = pulledBackCompliance(map, law);
      for (std::size_t m = 0; m < own.size(); ++m)
        compliances[m * CellForms::lanes + lane] = own[m];
    }
    const CellForms forms(reference);
    const CellForms::Condensed found = forms.condensed(compliances.data(), work);
    const double* entry = found.triangle;
    for (int j = 0; j < reference.data(); ++j)
      for (int i = j; i < reference.data(); ++i, entry += CellForms::lanes)
        for (std::size_t lane = 0; lane < CellForms::lanes; ++lane) {
          const DenseMatrix& A = expected[lane];
          EXPECT_NEAR(entry[lane], A(i, j), 1e-10 * std::sqrt(A(i, i) * A(j, j)));
        }
    const Vector T = random.vector(std::size_t(reference.data()) * CellForms::lanes);
    Vector forces(T.size());
    for (const int columns : {reference.tractions, reference.data()}) {
      forms.apply(compliances.data(), found.factor, T.data(), std::size_t(columns), forces.data());
      for (std::size_t lane = 0; lane < CellForms::lanes; ++lane)
        for (int i = 0; i < columns; ++i) {
          double force = 0.0, scale = 0.0;
          for (int j = 0; j < columns; ++j) {
            force += expected[lane](i, j) * T[std::size_t(j) * CellForms::lanes + lane];
            scale += std::abs(expected[lane](i, j));
          }
          EXPECT_NEAR(forces[std::size_t(i) * CellForms::lanes + lane], force, 1e-10 * scale) << lane;
        }
    }
    expectFacets(reference, forms.facets(compliances.data(), work), expected);
  }
}

TEST(ReferenceStress, IsComputedOnce)
{
  EXPECT_EQ(&referenceStress(2, 2), &referenceStress(2, 2));
}

TEST(ReferenceStress, RefusesDegreesWithoutTables)
{
  EXPECT_THROW(referenceStress(2, 4), InternalError);
  EXPECT_THROW(referenceStress(3, 4), InternalError);
  EXPECT_THROW(referenceStress(2, 0), InternalError);
}

TEST(ReferenceStress, HasTheTractionsItIsGiven)
{
  for (const StressKind& kind : test::stressKinds())
    for (unsigned seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(kind.name());
      const Mesh mesh = test::shuffledCell(kind.dim, seed);
      const StressCorrection moments = test::balancedMoments(mesh, kind.degree, seed + 20);
      const SplitStress stress = stressOf(mesh, moments);
      const MomentBasis basis = facetBasis(kind.dim, kind.degree);
      const QuadratureRule rule = simplexRule(kind.dim - 1, 2 * kind.degree);
      for (int f = 0; f <= kind.dim; ++f) {
        double normal[3];
        const double area = facetNormal(mesh, {0, stress.cell.local[std::size_t(f)]}, normal);
        for (int q = 0; q < rule.size(); ++q) {
          const auto given = fieldOf(basis, rule.point(q), &moments.tractions[std::size_t(f * basis.size() * kind.dim)],
                                     kind.dim, area);
          const auto lambda = test::facetPoint(kind.dim, f, rule.point(q));
          const auto found = tractionOf(stress, f, lambda.data(), normal);
          EXPECT_LT(test::size(test::difference(found, given)), 1e-12 * (1.0 + test::size(given)));
        }
      }
    }
}

TEST(ReferenceStress, HasTheDivergenceItIsGiven)
{
  for (const StressKind& kind : test::stressKinds())
    for (unsigned seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(kind.name());
      const Mesh mesh = test::shuffledCell(kind.dim, seed);
      const StressCorrection moments = test::balancedMoments(mesh, kind.degree, seed + 20);
      const SplitStress stress = stressOf(mesh, moments);
      const MomentBasis basis = loadBasis(kind.dim, kind.degree);
      test::overSubCells(kind.dim, 2 * kind.degree, [&](int sub, const double* lambda, double) {
        std::vector<double> found(std::size_t(kind.dim));
        stress.divergence(sub, lambda, found.data());
        const auto given = fieldOf(basis, lambda, moments.loads.data(), kind.dim, std::abs(cellMeasure(mesh, 0)));
        EXPECT_LT(test::size(test::difference(found, given)), 2e-12 * (1.0 + test::size(given)));
      });
    }
}

TEST(ReferenceStress, HasContinuousTractionsInside)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    const int dim = kind.dim;
    const Mesh mesh = test::shuffledCell(dim, 9);
    const SplitStress stress = stressOf(mesh, test::balancedMoments(mesh, kind.degree, 30));
    const QuadratureRule rule = simplexRule(dim - 1, 2 * kind.degree);
    for (int i = 0; i <= dim; ++i)
      for (int j = i + 1; j <= dim; ++j)
        for (int q = 0; q < rule.size(); ++q) {
          std::vector<double> lambda;
          for (int a = 0, next = 1; a <= dim; ++a)
            lambda.push_back(rule.point(q)[0] / (dim + 1) + (a == i || a == j ? 0.0 : rule.point(q)[next++]));
          const auto normal = innerNormal(mesh, stress.cell, i, j);
          const auto one = tractionOf(stress, i, lambda.data(), normal.data()),
                     other = tractionOf(stress, j, lambda.data(), normal.data());
          EXPECT_LT(test::size(test::difference(one, other)), 1e-11 * (1.0 + test::size(one)));
        }
  }
}

TEST(ReferenceStress, DivergenceIsTheDerivativeOfTheStress)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    const Mesh mesh = test::shuffledCell(kind.dim, 6);
    const SplitStress stress = stressOf(mesh, test::balancedMoments(mesh, kind.degree, 31));
    const std::vector<double> centroid(4, 1.0 / (kind.dim + 1));
    for (int sub = 0; sub <= kind.dim; ++sub) {
      // The sub-cell's polynomial, wherever x lies.
      const auto field = [&](const double* x, double* sigma) {
        std::vector<double> lambda(std::size_t(kind.dim + 1), 0.0), from(x, x + kind.dim);
        const auto relative =
            test::difference(from, test::pointOf(mesh, stress.cell, std::vector<double>{1, 0, 0, 0}.data()));
        lambda[0] = 1.0;
        for (int k = 1; k <= kind.dim; ++k)
          for (int i = 0; i < kind.dim; ++i) {
            const double part = stress.map.inverse[std::size_t((k - 1) * kind.dim + i)] * relative[std::size_t(i)];
            lambda[std::size_t(k)] += part;
            lambda[0] -= part;
          }
        stress.stress(sub, lambda.data(), sigma);
      };
      std::vector<double> found(std::size_t(kind.dim));
      stress.divergence(sub, centroid.data(), found.data());
      const auto expected =
          test::divergenceOf(field, kind.dim, test::pointOf(mesh, stress.cell, centroid.data()).data());
      EXPECT_LT(test::size(test::difference(found, expected)), 1e-10 * (1.0 + test::size(expected)));
    }
  }
}

TEST(ReferenceStress, BubblesHaveNeitherTractionNorDivergence)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    const ReferenceStress& tables = referenceStress(kind.dim, kind.degree);
    const Mesh mesh = referenceCell(kind.dim);
    const QuadratureRule rule = simplexRule(kind.dim - 1, 2 * kind.degree);
    for (int b = 0; b < tables.bubbles; ++b) {
      const SplitStress bubble = referenceField(kind, tables.bubble.column(b));
      EXPECT_NEAR(norm(bubble.coefficients), 1.0, 1e-13);
      test::overSubCells(kind.dim, 2 * kind.degree, [&](int sub, const double* lambda, double) {
        std::vector<double> divergence(std::size_t(kind.dim));
        bubble.divergence(sub, lambda, divergence.data());
        EXPECT_LT(test::size(divergence), 1e-12);
      });
      for (int f = 0; f <= kind.dim; ++f)
        for (int q = 0; q < rule.size(); ++q) {
          double normal[3];
          facetNormal(mesh, {0, f}, normal);
          const auto lambda = test::facetPoint(kind.dim, f, rule.point(q));
          EXPECT_LT(test::size(tractionOf(bubble, f, lambda.data(), normal)), 1e-13);
        }
    }
  }
}

TEST(ReferenceStress, EnergyTablesAreIntegralsOfProducts)
{
  for (const StressKind& kind : test::stressKinds()) {
    SCOPED_TRACE(kind.name());
    const ReferenceStress& tables = referenceStress(kind.dim, kind.degree);
    const Vector x = test::Random(3).vector(std::size_t(tables.data() + tables.bubbles));
    Vector coefficients = multiply(tables.lift, Vector(x.begin(), x.begin() + tables.data()));
    const Vector bubbles = multiply(tables.bubble, Vector(x.begin() + tables.data(), x.end()));
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      coefficients[i] += bubbles[i];
    const SplitStress S = referenceField(kind, coefficients);

    const std::size_t strains = kind.dim == 2 ? 3 : 6;
    Vector integrals(tables.energy.size(), 0.0);
    const double measure = cellMeasure(referenceCell(kind.dim), 0);
    test::overSubCells(kind.dim, 2 * kind.degree, [&](int sub, const double* lambda, double weight) {
      double s[6];
      S.stress(sub, lambda, s);
      std::size_t m = 0;
      for (std::size_t a = 0; a < strains; ++a)
        for (std::size_t b = a; b < strains; ++b)
          integrals[m++] += measure * weight * s[a] * s[b] * (a == b ? 1.0 : 2.0);
    });
    const double scale = dot(x, x);
    for (std::size_t m = 0; m < integrals.size(); ++m)
      EXPECT_NEAR(dot(x, multiplySymmetric(tables.energy[m], x)) / scale, integrals[m] / scale, 1e-12);
  }
}

TEST(CellMap, TakesTheReferenceSimplexToTheSortedCell)
{
  int insideOut = 0;
  for (int dim = 2; dim <= 3; ++dim)
    for (unsigned seed = 0; seed < 6; ++seed) {
      const Mesh mesh = test::shuffledCell(dim, seed);
      const SortedCell cell = sortedCell(mesh, 0);
      const CellMap map = cellMap(mesh, cell);
      for (int i = 0; i < dim; ++i)
        for (int k = 0; k < dim; ++k) {
          double identity = 0.0;
          for (int j = 0; j < dim; ++j)
            identity += map.F[std::size_t(i * dim + j)] * map.inverse[std::size_t(j * dim + k)];
          EXPECT_NEAR(identity, i == k ? 1.0 : 0.0, 1e-12);
          EXPECT_DOUBLE_EQ(map.F[std::size_t(i * dim + k)],
                           mesh.point(cell.vertices[std::size_t(k + 1)])[i] - mesh.point(cell.vertices[0])[i]);
        }
      EXPECT_NEAR(map.det, std::abs(cellMeasure(mesh, 0)) * (dim == 2 ? 2.0 : 6.0), 1e-14);
      Mesh sorted = mesh;
      std::copy_n(cell.vertices.begin(), dim + 1, sorted.cells.begin());
      insideOut += cellMeasure(sorted, 0) < 0.0;
    }
  EXPECT_GT(insideOut, 2); // the samples hold both kinds
  EXPECT_LT(insideOut, 10);
}

} // namespace ndframe
