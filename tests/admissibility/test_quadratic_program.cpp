#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ndframe/admissibility/quadratic_program.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double value() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  int number(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  Vector vector(int n)
  {
    Vector values;
    for (int i = 0; i < n; ++i)
      values.push_back(value());
    return values;
  }
  DenseMatrix matrix(int rows, int cols)
  {
    DenseMatrix A(rows, cols);
    for (int i = 0; i < rows * cols; ++i)
      A.data()[i] = value();
    return A;
  }

private:
  std::mt19937 engine_;
};

DenseMatrix positiveDefinite(Random& random, int n)
{
  const DenseMatrix R = random.matrix(n, n);
  DenseMatrix H = multiplyTransposed(R, R);
  for (int i = 0; i < n; ++i)
    H(i, i) += 0.1;
  return H;
}

/// A program that some point satisfies, with as many of its inequalities exactly met there as wanted.
QuadraticProgram feasibleProgram(Random& random, int n, int m, int metExactly)
{
  QuadraticProgram program{positiveDefinite(random, n), random.vector(n), random.matrix(m, n), {}};
  program.b = multiply(program.B, random.vector(n));
  for (int i = metExactly; i < m; ++i)
    program.b[std::size_t(i)] += std::abs(random.value());
  return program;
}

/// The largest violation of the four Karush-Kuhn-Tucker conditions.
double kktDefect(const QuadraticProgram& program, const QuadraticMinimum& minimum)
{
  Vector gradient = multiply(program.H, minimum.x);
  const Vector forces = multiplyTransposed(program.B, DenseMatrix(minimum.multipliers)).column(0),
               values = multiply(program.B, minimum.x);
  double defect = 0.0;
  for (std::size_t k = 0; k < gradient.size(); ++k)
    defect = std::max(defect, std::abs(gradient[k] + program.h[k] + forces[k]));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double slack = program.b[i] - values[i], multiplier = minimum.multipliers[i];
    defect = std::max({defect, -slack, -multiplier, std::abs(slack * multiplier)});
  }
  return defect;
}

double energy(const QuadraticProgram& program, const Vector& x)
{
  return 0.5 * dot(x, multiply(program.H, x)) + dot(program.h, x);
}

} // namespace

TEST(QuadraticProgram, RandomMinimaSatisfyTheKktConditions)
{
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const int n = random.number(1, 12), m = random.number(0, 24);
    const QuadraticProgram program = feasibleProgram(random, n, m, 0);
    const auto minimum = minimise(program);
    ASSERT_TRUE(minimum) << trial;
    EXPECT_LT(kktDefect(program, *minimum), 1e-10) << trial;
  }
}

TEST(QuadraticProgram, DegenerateMinimaSatisfyTheKktConditions)
{
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const int n = random.number(1, 8), m = random.number(n, 3 * n);
    QuadraticProgram program = feasibleProgram(random, n, m, m);
    for (int k = 0; k < n; ++k) { // a repeated row, its multiple, and one of nothing
      program.B(m / 2, k) = program.B(0, k);
      program.B(m - 1, k) = m > 2 ? 0.0 : program.B(m - 1, k);
    }
    program.b[std::size_t(m / 2)] = program.b[0];
    program.b[std::size_t(m - 1)] = m > 2 ? 0.0 : program.b[std::size_t(m - 1)];
    const auto minimum = minimise(program);
    ASSERT_TRUE(minimum) << trial;
    EXPECT_LT(kktDefect(program, *minimum), 1e-8) << trial;
  }
}

TEST(QuadraticProgram, APointWhereAllInequalitiesMeetIsKeptWhenItIsTheOnlyOne)
{
  // |x_1| + |x_2| <= 0 with its four faces
  QuadraticProgram program{DenseMatrix(2, 2), {-3.0, 1.0}, DenseMatrix(4, 2), Vector(4, 0.0)};
  program.H(0, 0) = 2.0, program.H(1, 1) = 5.0;
  for (int i = 0; i < 4; ++i) {
    program.B(i, 0) = i % 2 == 0 ? 1.0 : -1.0;
    program.B(i, 1) = i < 2 ? 1.0 : -1.0;
  }
  const auto minimum = minimise(program);
  ASSERT_TRUE(minimum);
  EXPECT_LT(norm(minimum->x), 1e-15);
  EXPECT_LT(kktDefect(program, *minimum), 1e-14);
}

TEST(QuadraticProgram, InequalitiesHoldRelativeToTheMinimumHoweverFarItIsPulled)
{
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    QuadraticProgram program = feasibleProgram(random, 5, 8, 8);
    for (double& value : program.h)
      value *= 1e8;
    const auto minimum = minimise(program);
    ASSERT_TRUE(minimum) << trial;
    const Vector values = multiply(program.B, minimum->x);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_LT(values[i] - program.b[i], 1e-12 * (norm(minimum->x) + norm(program.b))) << trial;
  }
}

TEST(QuadraticProgram, NoAdmissiblePointHasLessEnergy)
{
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const QuadraticProgram program = feasibleProgram(random, 5, 9, 3);
    const auto minimum = minimise(program);
    ASSERT_TRUE(minimum);
    const double least = energy(program, minimum->x);
    for (int other = 0; other < 200; ++other) {
      Vector x = minimum->x;
      for (double& value : x)
        value += 0.3 * random.value();
      const Vector values = multiply(program.B, x);
      const bool admissible = std::equal(values.begin(), values.end(), program.b.begin(), std::less_equal<>());
      if (admissible) {
        EXPECT_GE(energy(program, x), least - 1e-13);
      }
    }
  }
}

TEST(QuadraticProgram, WithoutInequalitiesTheFreeMinimumIsFound)
{
  Random random(4);
  const QuadraticProgram program = feasibleProgram(random, 6, 0, 0);
  const auto minimum = minimise(program);
  ASSERT_TRUE(minimum);
  EXPECT_LT(kktDefect(program, *minimum), 1e-13);
}

TEST(QuadraticProgram, OfNoUnknownsIsJudgedByItsBounds)
{
  EXPECT_TRUE(minimise({DenseMatrix(0, 0), {}, DenseMatrix(2, 0), {0.0, 1.0}}));
  EXPECT_FALSE(minimise({DenseMatrix(0, 0), {}, DenseMatrix(2, 0), {0.0, -1.0}}));
}

TEST(QuadraticProgram, ContradictionsAreFound)
{
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const int n = random.number(1, 6);
    QuadraticProgram program = feasibleProgram(random, n, n + 3, 0);
    for (int k = 0; k < n; ++k) // the last three: a x <= c, a' x <= c', (a + a') x >= c + c' + 1
      program.B(n + 2, k) = -program.B(n, k) - program.B(n + 1, k);
    program.b[std::size_t(n + 2)] = -program.b[std::size_t(n)] - program.b[std::size_t(n + 1)] - 1.0;
    EXPECT_FALSE(minimise(program)) << trial;
  }
}

TEST(QuadraticProgram, UnitsOfEverythingDoNotMatter)
{
  Random random(6);
  const QuadraticProgram program = feasibleProgram(random, 5, 9, 4);
  QuadraticProgram scaled = program;
  const double length = 1e-9, force = 1e12; // x as a length, energies as force * length
  for (int i = 0; i < 25; ++i)
    scaled.H.data()[i] *= force / length;
  for (double& value : scaled.h)
    value *= force;
  for (double& value : scaled.b)
    value *= length;
  const auto one = minimise(program), other = minimise(scaled);
  ASSERT_TRUE(one && other);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(other->x[k] / length, one->x[k], 1e-12);
}

TEST(QuadraticProgram, RefusesShapesThatDoNotMatch)
{
  EXPECT_THROW(minimise({DenseMatrix(2, 2), Vector(3), DenseMatrix(0, 2), {}}), InternalError);
}

} // namespace ndframe
