#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "banded_program.hpp"
#include "ndframe/admissibility/quadratic_program.hpp"

namespace ndframe
{

namespace
{

double value(std::mt19937& random)
{
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

/// M = R^T R of a banded R with a positive diagonal, f of any sign; conditions that a random x <= 0 meets.
BandedProgram randomProgram(int n, int bandwidth, int conditions, std::mt19937& random)
{
  BandedProgram program{SymmetricRows(n), Vector(std::size_t(n)), SparseColumns(n, conditions),
                        Vector(std::size_t(conditions))};
  DenseMatrix R(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = std::max(0, j - bandwidth); i <= j; ++i)
      R(i, j) = value(random) + (i == j ? 2.0 : 0.0);
  const DenseMatrix M = multiplyTransposed(R, R);
  for (int j = 0; j < n; ++j)
    for (int i = j; i < std::min(n, j + bandwidth + 1); ++i)
      program.M.add(i, j, M(i, j));
  for (int i = 0; i < n; ++i)
    program.f[std::size_t(i)] = 5.0 * value(random);
  for (int k = 0; k < conditions; ++k)
    for (int i = 0; i < n; ++i) {
      program.W(i, k) = value(random);
      program.r[std::size_t(k)] += program.W(i, k) * std::min(0.0, program.f[std::size_t(i)]);
    }
  return program;
}

/// The same program without structure; conditions as pairs of inequalities.
Vector denseMinimum(const BandedProgram& program)
{
  const int n = program.M.size(), conditions = program.W.cols(), rows = n + 2 * conditions;
  QuadraticProgram dense{DenseMatrix(n, n), program.f, DenseMatrix(rows, n), Vector(std::size_t(rows), 0.0)};
  for (int i = 0; i < n; ++i) {
    dense.h[std::size_t(i)] *= -1.0;
    dense.B(i, i) = 1.0;
    for (const auto& [j, entry] : program.M.rows()[std::size_t(i)])
      dense.H(i, j) = entry;
    for (int k = 0; k < conditions; ++k) {
      dense.B(n + 2 * k, i) = program.W(i, k);
      dense.B(n + 2 * k + 1, i) = -program.W(i, k);
    }
  }
  for (int k = 0; k < conditions; ++k) {
    dense.b[std::size_t(n + 2 * k)] = program.r[std::size_t(k)];
    dense.b[std::size_t(n + 2 * k + 1)] = -program.r[std::size_t(k)];
  }
  const auto minimum = minimise(dense);
  return minimum ? minimum->x : Vector();
}

void expectSame(const Vector& x, const Vector& y, double tolerance)
{
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(x[i], y[i], tolerance) << i;
}

} // namespace

TEST(BandedProgram, AgreesWithTheDenseActiveSetMethod)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 3 + int(random() % 14), bandwidth = int(random() % 4), conditions = int(random() % 4);
    const BandedProgram program = randomProgram(n, bandwidth, conditions, random);
    const Vector x = *minimise(program);
    expectSame(x, denseMinimum(program), 1e-11);
    EXPECT_LE(*std::max_element(x.begin(), x.end()), 0.0);
  }
}

TEST(BandedProgram, ANumberingThatMakesTheBandWideChangesNothing)
{
  constexpr int n = 90;
  std::mt19937 random(4);
  for (int conditions = 0; conditions < 3; ++conditions) {
    const BandedProgram program = randomProgram(n, 2, conditions, random);
    BandedProgram wide{SymmetricRows(n), Vector(std::size_t(n)), SparseColumns(n, conditions), program.r};
    const auto place = [](int i) { return 37 * i % n; };
    for (int i = 0; i < n; ++i) {
      wide.f[std::size_t(place(i))] = program.f[std::size_t(i)];
      for (int j = std::max(0, i - 2); j <= i; ++j)
        wide.M.add(place(i), place(j), program.M(i, j));
      for (int k = 0; k < conditions; ++k)
        wide.W(place(i), k) = program.W(i, k);
    }
    const Vector x = *minimise(program), y = *minimise(wide);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(y[std::size_t(place(i))], x[std::size_t(i)], 1e-11) << i;
  }
}

TEST(BandedProgram, DependentAndVanishingConditionsAreHarmless)
{
  std::mt19937 random(2);
  BandedProgram program = randomProgram(12, 2, 2, random);
  const Vector x = *minimise(program);
  SparseColumns W(12, 4);
  for (int i = 0; i < 12; ++i) {
    W(i, 0) = program.W(i, 0), W(i, 1) = program.W(i, 1);
    W(i, 2) = program.W(i, 0) - 2.0 * program.W(i, 1);
  }
  program.W = W;
  program.r = {program.r[0], program.r[1], program.r[0] - 2.0 * program.r[1], 0.0};
  expectSame(*minimise(program), x, 1e-11);
}

TEST(BandedProgram, ConditionsThatOnePointMeetsFindIt)
{
  // the resultant and the moment of a force at the last entry
  BandedProgram program{SymmetricRows(6), Vector(6, 3.0), SparseColumns(6, 2), {-2.0, -10.0}};
  for (int i = 0; i < 6; ++i) {
    program.M.add(i, i, 2.0);
    if (i > 0)
      program.M.add(i, i - 1, 0.5);
    program.W(i, 0) = 1.0, program.W(i, 1) = i;
  }
  expectSame(*minimise(program), {0.0, 0.0, 0.0, 0.0, 0.0, -2.0}, 1e-12);
}

TEST(BandedProgram, DegenerateDataEnd)
{
  // f = M x with x <= 0 that has zeros: entries and their multipliers vanish together
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    BandedProgram program = randomProgram(20, 2, 0, random);
    Vector x(20, 0.0);
    for (std::size_t i = 0; i < 20; i += 1 + random() % 3)
      x[i] = -std::abs(value(random));
    program.f = product(program.M.rows(), x);
    expectSame(*minimise(program), x, 1e-13);
  }
}

TEST(BandedProgram, OfNothingIsSolved)
{
  EXPECT_TRUE(minimise(BandedProgram{SymmetricRows(0), {}, {}, {}})->empty());
}

} // namespace ndframe
