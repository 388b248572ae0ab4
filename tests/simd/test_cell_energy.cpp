#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "equilibrium/sample_stress.hpp"
#include "fem/sample_meshes.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"
#include "ndframe/simd/cell_distances.hpp"

namespace ndframe
{
namespace
{

using test::StressKind;

Vector dataOf(const StressCorrection& correction)
{
  Vector x = correction.tractions;
  x.insert(x.end(), correction.loads.begin(), correction.loads.end());
  return x;
}

DenseMatrix energyMatrix(const Mesh& mesh, int degree, const Elasticity& law)
{
  return cellEnergyMatrix(referenceStress(mesh.dim, degree), cellMap(mesh, sortedCell(mesh, 0)), law);
}

/// x^T A x of one cell.
double energyOf(const Mesh& mesh, const Elasticity& law, const StressCorrection& correction)
{
  const Vector x = dataOf(correction);
  return dot(x, multiplySymmetric(energyMatrix(mesh, correction.degree, law), x));
}

/// int sigma : C^-1 sigma over one cell, sigma by sub-cell and barycentric point.
double complementaryEnergy(const Mesh& mesh, const Elasticity& law, int degree,
                           const std::function<void(int sub, const double* lambda, double* sigma)>& field)
{
  DenseMatrix stiffness(law.strains(), law.strains());
  for (int i = 0; i < law.strains(); ++i)
    for (int j = 0; j < law.strains(); ++j)
      stiffness(i, j) = law(i, j);
  const DenseCholesky factor(stiffness);
  double energy = 0.0;
  test::overSubCells(mesh.dim, 2 * degree, [&](int sub, const double* lambda, double weight) {
    Vector sigma(std::size_t(law.strains()));
    field(sub, lambda, sigma.data());
    energy += weight * dot(sigma, factor.solve(sigma));
  });
  return energy * std::abs(cellMeasure(mesh, 0));
}

Vector zeros(const BodyModel& body)
{
  return Vector(std::size_t(body.numDofs()), 0.0);
}

/// Points turned by 40 degrees about z and moved.
Mesh turned(const Mesh& mesh)
{
  return test::moved(mesh, [&](double* x) {
    const double c = std::cos(0.7), s = std::sin(0.7), x0 = x[0];
    x[0] = c * x0 - s * x[1] + 3.0;
    x[1] = s * x0 + c * x[1] - 2.0;
  });
}

/// The vectors of a correction turned likewise.
StressCorrection turned(StressCorrection correction)
{
  for (Vector* vectors : {&correction.tractions, &correction.loads})
    for (std::size_t i = 0; i < vectors->size(); i += std::size_t(correction.dim)) {
      const double c = std::cos(0.7), s = std::sin(0.7), x = (*vectors)[i], y = (*vectors)[i + 1];
      (*vectors)[i] = c * x - s * y;
      (*vectors)[i + 1] = s * x + c * y;
    }
  return correction;
}

} // namespace

TEST(CellEnergy, IsSymmetricAndPositiveOnBalancedData)
{
  for (const StressKind& kind : test::recoveredKinds())
    for (const Elasticity& law : test::sampleLaws(kind.dim)) {
      SCOPED_TRACE(kind.name());
      const Mesh mesh = test::shuffledCell(kind.dim, 2);
      const DenseMatrix A = energyMatrix(mesh, kind.degree, law);
      double largest = 0.0;
      for (int i = 0; i < A.rows(); ++i)
        largest = std::max(largest, A(i, i));
      for (int i = 0; i < A.rows(); ++i)
        for (int j = 0; j < i; ++j)
          EXPECT_NEAR(A(i, j), A(j, i), 1e-13 * largest);
      for (unsigned seed = 0; seed < 5; ++seed)
        EXPECT_GT(energyOf(mesh, law, test::balancedMoments(mesh, kind.degree, seed)), 0.0);
    }
}

TEST(CellEnergy, IsTheEnergyOfTheStress)
{
  for (const StressKind& kind : test::recoveredKinds())
    for (const Elasticity& law : test::sampleLaws(kind.dim)) {
      SCOPED_TRACE(kind.name());
      const BodyModel body = test::bodyOf(test::shuffledCell(kind.dim, 3), 1, law);
      const StressCorrection correction = test::balancedMoments(body.mesh, kind.degree, 4);
      const SplitStress stress = equilibratedStress(body, zeros(body), correction, 0);
      const double byQuadrature =
          complementaryEnergy(body.mesh, law, kind.degree,
                              [&](int sub, const double* lambda, double* sigma) { stress.stress(sub, lambda, sigma); });
      EXPECT_NEAR(energyOf(body.mesh, law, correction) / byQuadrature, 1.0, 1e-11);
      EXPECT_NEAR(cellDistances(body, correction, nullptr)[0] / byQuadrature, 1.0, 1e-11);
    }
}

TEST(CellEnergy, OfManySolidCellsIsThatOfEachAlone)
{
  const auto laws = test::sampleLaws(3);
  for (const int degree : {1, 2})
    for (int order = 1; order <= degree; ++order) {
      BodyModel body = test::bodyOf(test::shaken(test::box({2, 3, 3}), 0.05, 3), order, laws[0]);
      std::vector<int> ofCell, cells;
      for (int c = 0; c < body.mesh.numCells(); ++c) {
        ofCell.push_back(c % int(laws.size()));
        if (c % 5 != 3)
          cells.push_back(c);
      }
      body.laws = CellLaws(laws, ofCell);
      test::Random random(8);
      StressCorrection correction = zeroCorrection(body.mesh, degree);
      correction.tractions = random.vector(correction.tractions.size());
      correction.loads = random.vector(correction.loads.size());
      const Vector u = random.vector(std::size_t(body.numDofs()));
      const Vector found = solidDistances(body, correction, &u, cells);
      ASSERT_EQ(found.size(), cells.size());
      ASSERT_NE(found.size() % 8, 0U) << "some lanes are without a cell";
      for (std::size_t i = 0; i < cells.size(); ++i)
        EXPECT_NEAR(found[i] / equilibratedStress(body, u, correction, cells[i]).energy(body.laws(cells[i])), 1.0,
                    1e-10)
            << "cell " << cells[i] << ", degree " << degree << ", order " << order;
    }
}

TEST(CellEnergy, OfAnElasticStressIsTheDisplacementsEnergy)
{
  // A compatible strain is orthogonal to all bubbles: the stress of least energy is K eps(u) itself.
  for (const StressKind& kind : test::recoveredKinds())
    for (const Elasticity& law : test::sampleLaws(kind.dim))
      for (int order = 1; order <= std::min(2, kind.degree); ++order) {
        SCOPED_TRACE(kind.name());
        const BodyModel body = test::bodyOf(test::shuffledCell(kind.dim, 5), order, law);
        const test::ElasticField field = test::elasticField(law, order, 6);
        const StressCorrection moments = test::momentsOf(field.stress, body.mesh, kind.degree);
        const Vector u = test::interpolate(body.nodes, field.displacement);
        EXPECT_NEAR(energyOf(body.mesh, law, moments) / cellEnergies(body, u)[0], 1.0, 1e-9);

        const SplitStress stress = equilibratedStress(body, zeros(body), moments, 0);
        test::overSubCells(kind.dim, 2, [&](int sub, const double* lambda, double) {
          std::vector<double> found(std::size_t(law.strains())), expected = found;
          stress.stress(sub, lambda, found.data());
          field.stress(test::pointOf(body.mesh, stress.cell, lambda).data(), expected.data());
          EXPECT_LT(test::size(test::difference(found, expected)), 1e-9 * test::size(expected));
        });
      }
}

TEST(CellEnergy, IsNotAboveThatOfAnotherStressWithTheSameData)
{
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    const Elasticity law = test::sampleLaws(kind.dim)[2];
    const Mesh mesh = test::shuffledCell(kind.dim, 8);
    const test::StressField field = test::polynomialStress(kind.dim, kind.degree, 9);
    const SortedCell cell = sortedCell(mesh, 0);
    const double its = complementaryEnergy(mesh, law, kind.degree, [&](int, const double* lambda, double* sigma) {
      field(test::pointOf(mesh, cell, lambda).data(), sigma);
    });
    const double least = energyOf(mesh, law, test::momentsOf(field, mesh, kind.degree));
    EXPECT_LE(least, its * (1.0 + 1e-12));
    if (referenceStress(kind.dim, kind.degree).bubbles == 0)
      EXPECT_NEAR(least / its, 1.0, 1e-12);
    else
      EXPECT_LT(least, (1.0 - 1e-6) * its);
  }
}

TEST(CellEnergy, DoesNotDependOnTheOrderOfVertices)
{
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    const Elasticity law = test::sampleLaws(kind.dim)[1];
    const Mesh mesh = test::randomCell(kind.dim, 12);
    const test::StressField field = test::polynomialStress(kind.dim, kind.degree, 13);
    const double reference = energyOf(mesh, law, test::momentsOf(field, mesh, kind.degree));
    std::vector<int> number;
    for (int v = 0; v <= kind.dim; ++v)
      number.push_back(v);
    while (std::next_permutation(number.begin(), number.end())) {
      Mesh other = mesh;
      for (int v = 0; v <= kind.dim; ++v) {
        other.cells[std::size_t(v)] = number[std::size_t(v)];
        std::copy_n(mesh.point(v), kind.dim, other.points.begin() + number[std::size_t(v)] * kind.dim);
      }
      EXPECT_NEAR(energyOf(other, law, test::momentsOf(field, other, kind.degree)) / reference, 1.0, 1e-11);
    }
  }
}

TEST(CellEnergy, TurnsWithTheBody)
{
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    const Elasticity law = test::sampleLaws(kind.dim)[0];
    const Mesh mesh = test::shuffledCell(kind.dim, 14);
    const StressCorrection correction = test::balancedMoments(mesh, kind.degree, 15);
    EXPECT_NEAR(energyOf(turned(mesh), law, turned(correction)) / energyOf(mesh, law, correction), 1.0, 1e-11);
  }
}

TEST(CellEnergy, ScalesWithTheUnits)
{
  const double length = 1e-3, stiffness = 2.1e11;
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    Elasticity law = test::sampleLaws(kind.dim)[0];
    Mesh mesh = test::shuffledCell(kind.dim, 16);
    const StressCorrection correction = test::balancedMoments(mesh, kind.degree, 17);
    const double energy = energyOf(mesh, law, correction);
    for (double& entry : law.D)
      entry *= stiffness;
    for (double& x : mesh.points)
      x *= length;
    // Forces as they are: force^2 / (stiffness length^(dim - 2)).
    EXPECT_NEAR(energyOf(mesh, law, correction) * stiffness * std::pow(length, kind.dim - 2) / energy, 1.0, 1e-11);
  }
}

TEST(CellDistances, AreRightOnFlatAndNearlyIncompressibleCells)
{
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    const Elasticity law = test::sampleLaws(kind.dim)[1];
    const Mesh mesh = test::moved(test::shuffledCell(kind.dim, 18), [](double* x) { x[1] *= 1e-2; });
    const test::ElasticField field = test::elasticField(law, 1, 19);
    const BodyModel body = test::bodyOf(mesh, 1, law);
    const double expected = cellEnergies(body, test::interpolate(body.nodes, field.displacement))[0];
    const StressCorrection correction = test::momentsOf(field.stress, mesh, kind.degree);
    EXPECT_NEAR(cellDistances(body, correction, nullptr)[0] / expected, 1.0, 1e-8);
  }
}

TEST(CellDistances, AreThoseOfTheStressesThemselves)
{
  for (const StressKind& kind : test::recoveredKinds())
    for (int order = 1; order <= std::min(2, kind.degree); ++order) {
      SCOPED_TRACE(kind.name());
      const Elasticity law = test::sampleLaws(kind.dim)[2];
      const BodyModel body = test::bodyOf(test::shuffledCell(kind.dim, 21), order, law);
      const StressCorrection correction = test::balancedMoments(body.mesh, kind.degree, 22);
      const Vector v = test::Random(23).vector(std::size_t(body.numDofs()));
      // K eps(u~) + c - K eps(u) = c + K eps(v)
      const SplitStress stress = equilibratedStress(body, v, correction, 0);
      const double expected =
          complementaryEnergy(body.mesh, law, kind.degree,
                              [&](int sub, const double* lambda, double* sigma) { stress.stress(sub, lambda, sigma); });
      EXPECT_NEAR(cellDistances(body, correction, &v)[0] / expected, 1.0, 1e-11);
    }
}

/// Data that begin with zeros, as those that carry the oscillation of body forces do, take a shorter way.
TEST(CellDistances, OfLoadsThatWorkOnNoAffineFunctionAreThoseOfTheStressesThemselves)
{
  const Elasticity law = test::sampleLaws(2)[1];
  const BodyModel body = test::bodyOf(test::shuffledCell(2, 24), 2, law);
  for (std::size_t first = 6; first < 12; ++first) {
    StressCorrection correction = zeroCorrection(body.mesh, 3);
    test::Random random(25);
    for (std::size_t i = first; i < 12; ++i)
      correction.loads[i] = random(-1.0, 1.0);
    const SplitStress stress = equilibratedStress(body, zeros(body), correction, 0);
    const double expected = complementaryEnergy(
        body.mesh, law, 3, [&](int sub, const double* lambda, double* sigma) { stress.stress(sub, lambda, sigma); });
    EXPECT_NEAR(cellDistances(body, correction, nullptr)[0] / expected, 1.0, 1e-11);
  }
}

TEST(CellDistances, FollowFromTheWorkOfTheMoments)
{
  // |c|^2 + 2 <c, eps(v)> + |eps(v)|^2 with <c, eps(v)> = - int div c . v + int c n . v
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    const Elasticity law = test::sampleLaws(kind.dim)[0];
    const BodyModel body = test::bodyOf(test::shuffledCell(kind.dim, 26), 1, law);
    const StressCorrection correction = test::balancedMoments(body.mesh, kind.degree, 27);
    const Vector v = test::Random(28).vector(std::size_t(body.numDofs()));
    const SortedCell cell = sortedCell(body.mesh, 0);
    const double work = test::workOf(correction, body.mesh, [&](const double* lambda, int component) {
      double value = 0.0;
      for (std::size_t a = 0; a <= std::size_t(kind.dim); ++a)
        value += lambda[a] * v[std::size_t(cell.vertices[a] * kind.dim + component)];
      return value;
    });
    const double expected = cellDistances(body, correction, nullptr)[0] + 2.0 * work + cellEnergies(body, v)[0];
    EXPECT_NEAR(cellDistances(body, correction, &v)[0] / expected, 1.0, 1e-11);
  }
}

TEST(CellDistances, VanishWhenTheCorrectionUndoesTheDifference)
{
  for (const StressKind& kind : test::recoveredKinds()) {
    SCOPED_TRACE(kind.name());
    const Elasticity law = test::sampleLaws(kind.dim)[0];
    const int order = std::min(2, kind.degree);
    const BodyModel body = test::bodyOf(test::shuffledCell(kind.dim, 24), order, law);
    const test::ElasticField field = test::elasticField(law, order, 25);
    Vector v = test::interpolate(body.nodes, field.displacement);
    const StressCorrection correction = test::momentsOf(field.stress, body.mesh, kind.degree);
    const double energy = cellEnergies(body, v)[0];
    for (double& value : v)
      value = -value;
    const double distance = cellDistances(body, correction, &v)[0];
    EXPECT_GE(distance, 0.0);
    EXPECT_LT(distance, 1e-11 * energy);
  }
}

} // namespace ndframe
