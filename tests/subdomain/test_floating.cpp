#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ndframe/base/diagnostics.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

namespace
{

SampleProblem floating(DenseMatrix A, int modes, Vector b, Vector bound)
{
  const auto n = std::size_t(A.rows());
  return {std::move(A), std::move(b), std::move(bound), std::vector<char>(n, 1), modes};
}

/// Loads that press everywhere: contact can always carry them.
Vector pressing(int size, unsigned seed)
{
  Vector b = randomNumbers(size, seed);
  for (double& value : b)
    value = 0.1 + value * value;
  return b;
}

/// A load that contact can just carry: two nodes take nearly all of it, the others are on the verge of opening.
SampleProblem tilted(unsigned seed)
{
  const int size = 6;
  DenseMatrix A = floatingBeam(size);
  const Vector force = randomNumbers(size, seed);
  Vector b = multiply(A, randomNumbers(size, seed + 1));
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] += std::abs(force[i]) * (i == seed % 6 || i == seed / 6 % 6 ? 5.0 : 1e-3);
  return floating(std::move(A), 2, std::move(b), randomNumbers(size, seed + 2));
}

std::string failureOf(const SampleProblem& problem)
{
  try {
    solve(problem);
  } catch (const NotConverged& failure) {
    return failure.what();
  }
  return "no failure";
}

std::vector<double> shiftsOf(const SampleProblem& problem, UnilateralState& state)
{
  Ledger ledger;
  const ShiftRecorder A(problem.A);
  UnilateralProblem unilateral(A, problem.constrained, rigidMotions(problem.size(), problem.modes),
                               motionNames(problem.modes), ledger);
  state = unilateral.solve(problem.b, problem.bound, problem.allClosed());
  return A.shifts;
}

bool needsProximalTerm(const SampleProblem& problem)
{
  UnilateralState state;
  const auto shifts = shiftsOf(problem, state);
  return std::any_of(shifts.begin(), shifts.end(), [](double shift) { return shift > 0.0; });
}

} // namespace

TEST(FloatingBody, PressedWithOneFreeMotionAgreesWithTryingEveryClosedSet)
{
  for (int size = 2; size <= 7; ++size)
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(testing::Message() << "size " << size << ", seed " << seed);
      const auto problem = floating(floatingChain(size), 1, pressing(size, seed), randomNumbers(size, seed + 1));
      expectSame(solve(problem), bruteForce(problem));
    }
}

TEST(FloatingBody, PressedWithTwoFreeMotionsAgreesWithTryingEveryClosedSet)
{
  for (int size = 3; size <= 7; ++size)
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(testing::Message() << "size " << size << ", seed " << seed);
      const auto problem = floating(floatingBeam(size), 2, pressing(size, seed), randomNumbers(size, seed + 1));
      expectSame(solve(problem), bruteForce(problem));
    }
}

TEST(FloatingBody, MixedLoadsWithAPressingResultantAreCarried)
{
  for (unsigned seed = 0; seed < 100; ++seed) {
    Vector b = randomNumbers(6, seed);
    double sum = 0.0;
    for (const double value : b)
      sum += value;
    b[seed % 6] += 0.5 - sum; // the resultant presses, single nodes are pulled
    const auto problem = floating(floatingChain(6), 1, b, randomNumbers(6, seed + 1));
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    expectSame(solve(problem), bruteForce(problem));
  }
}

TEST(FloatingBody, TiltingLoadExchangesTheNodesThatHoldTheBody)
{
  int exchanges = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto problem = tilted(seed);
    exchanges += needsProximalTerm(problem);
    expectSame(solve(problem), bruteForce(problem));
  }
  EXPECT_GE(exchanges, 5) << "no sample problem loses its hold on the way any more: choose other seeds";
}

TEST(FloatingBody, TheAnswerIsThatOfTheProblemWithoutProximalTerm)
{
  for (unsigned seed = 0; seed < 200; ++seed) {
    UnilateralState state;
    const auto problem = tilted(seed);
    EXPECT_EQ(shiftsOf(problem, state).back(), 0.0);
    EXPECT_LT(kktDefect(problem, state), 1e-12);
  }
}

TEST(FloatingBody, ProximalTermScalesWithTheUnits)
{
  const double stiffness = 1e9, length = 1e-3;
  for (unsigned seed = 0; seed < 200; ++seed) {
    auto problem = tilted(seed);
    const auto answer = solve(problem);
    for (int i = 0; i < 36; ++i)
      problem.A.data()[i] *= stiffness;
    for (std::size_t i = 0; i < 6; ++i) {
      problem.b[i] *= stiffness * length;
      problem.bound[i] *= length;
    }
    const auto inOtherUnits = solve(problem);
    EXPECT_EQ(inOtherUnits.closed, answer.closed) << "seed " << seed;
    EXPECT_EQ(inOtherUnits.passes, answer.passes) << "seed " << seed;
  }
}

TEST(FloatingBody, PulledOffNamesTheFreeMotion)
{
  EXPECT_THAT(failureOf(floating(floatingChain(4), 1, Vector(4, -1.0), Vector(4, 0.0))),
              AllOf(HasSubstr("does not press the bodies together"), HasSubstr("translation along y")));
  EXPECT_THAT(failureOf(floating(floatingBeam(5), 2, Vector(5, -1.0), Vector(5, 0.0))),
              HasSubstr("translation along y, rotation about (0, 0)"));
}

TEST(FloatingBody, TippingOverIsNotConverged)
{
  // The resultant presses but lies left of all nodes.
  EXPECT_THAT(failureOf(floating(floatingBeam(5), 2, {3.0, 0.0, 0.0, 0.0, -1.0}, Vector(5, 0.0))),
              HasSubstr("rotation about (0, 0)"));
}

TEST(FloatingBody, WithoutAnyStiffnessIsHeldByTwoNodes)
{
  // As many nodes as free motions: the condensed body is rigid, A = 0.
  const auto pressed = solve(floating(DenseMatrix(2, 2), 2, {1.0, 2.0}, {0.5, 0.25}));
  EXPECT_EQ(pressed.u, (Vector{0.5, 0.25}));
  EXPECT_EQ(pressed.force, (Vector{-1.0, -2.0}));
  EXPECT_THAT(failureOf(floating(DenseMatrix(2, 2), 2, {1.0, -2.0}, {0.5, 0.25})),
              HasSubstr("does not press the bodies together"));
}

TEST(FloatingBody, SupportsThatWereNotDeclaredFreeAreNotConverged)
{
  // A is singular although no free motion was named: an answer would be arbitrary.
  EXPECT_THAT(
      failureOf(floating(floatingChain(3), 0, {-1.0, -1.0, -1.0}, Vector(3, 0.0))),
      EndsWith("do not hold the bodies: nothing but contact does, and it hardly presses; add a support (a Point if the "
               "body is in balance)"));
}
