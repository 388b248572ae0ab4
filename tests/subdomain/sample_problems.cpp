#include "subdomain/sample_problems.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "algebra/spring_chain.hpp"

namespace ndframe::test
{

namespace
{

double largest(const Vector& values)
{
  double m = 0.0;
  for (const double value : values)
    m = std::max(m, std::abs(value));
  return m;
}

std::vector<char> bits(int number, int size)
{
  std::vector<char> set;
  for (int i = 0; i < size; ++i)
    set.push_back(char(number >> i & 1));
  return set;
}

/// The solution with this closed set, whatever the signs; nothing when the set does not hold the body.
std::optional<UnilateralState> solutionOn(const SampleProblem& problem, const std::vector<char>& closed)
{
  const auto A = makeDenseOperator(problem.A);
  UnilateralState state;
  state.closed = closed;
  Vector given = problem.bound, rhs = problem.b;
  std::vector<char> isFree;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    given[i] = closed[i] ? problem.bound[i] : 0.0;
    isFree.push_back(!closed[i]);
  }
  const Vector moved = A->apply(given);
  for (std::size_t i = 0; i < rhs.size(); ++i)
    rhs[i] -= moved[i];
  try {
    state.u = A->inverseOn(isFree, 0.0)->solve(rhs);
  } catch (const NotPositiveDefinite&) {
    return {};
  }
  for (std::size_t i = 0; i < given.size(); ++i)
    state.u[i] += given[i];
  state.force = A->apply(state.u);
  for (std::size_t i = 0; i < given.size(); ++i)
    state.force[i] = closed[i] ? state.force[i] - problem.b[i] : 0.0;
  return state;
}

} // namespace

Vector randomNumbers(int size, unsigned seed)
{
  std::mt19937 random(seed);
  Vector values;
  for (int i = 0; i < size; ++i)
    values.push_back(double(random() % 20001) / 10000.0 - 1.0);
  return values;
}

DenseMatrix randomSpd(int size, unsigned seed)
{
  DenseMatrix A(size, size);
  const Vector B = randomNumbers(size * size, seed);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      A(i, j) = i == j ? 0.05 : 0.0;
      for (int k = 0; k < size; ++k)
        A(i, j) += B[std::size_t(i * size + k)] * B[std::size_t(j * size + k)];
    }
  return A;
}

DenseMatrix floatingChain(int size)
{
  return springChain(size);
}

DenseMatrix floatingBeam(int size)
{
  DenseMatrix A(size, size);
  const double bend[] = {1.0, -2.0, 1.0};
  for (int i = 0; i + 2 < size; ++i)
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        A(i + k, i + l) += bend[k] * bend[l];
  return A;
}

DenseMatrix rigidMotions(int size, int modes)
{
  DenseMatrix motions(size, modes);
  for (int i = 0; i < size; ++i)
    for (int m = 0; m < modes; ++m)
      motions(i, m) = m == 0 ? 1.0 : double(i) / size;
  return motions;
}

std::vector<std::string> motionNames(int modes)
{
  const std::vector<std::string> names{"translation along y", "rotation about (0, 0)"};
  return {names.begin(), names.begin() + modes};
}

SampleProblem randomProblem(int size, unsigned seed)
{
  SampleProblem problem{randomSpd(size, seed), randomNumbers(size, seed + 1), randomNumbers(size, seed + 2),
                        std::vector<char>(std::size_t(size), 1), 0};
  if (seed % 2 == 1)
    problem.constrained[seed % std::size_t(size)] = 0;
  return problem;
}

UnilateralState bruteForce(const SampleProblem& problem)
{
  std::vector<UnilateralState> found;
  for (int set = 0; set < 1 << problem.size(); ++set) {
    const auto closed = bits(set, problem.size());
    bool allowed = true;
    for (std::size_t i = 0; i < closed.size(); ++i)
      allowed = allowed && (!closed[i] || problem.constrained[i]);
    const auto state = allowed ? solutionOn(problem, closed) : std::nullopt;
    if (state && kktDefect(problem, *state) < 1e-12)
      found.push_back(*state);
  }
  EXPECT_EQ(found.size(), 1u) << "the sample problem does not have exactly one solution";
  return found.empty() ? UnilateralState{} : found.front();
}

UnilateralState solve(const SampleProblem& problem, std::vector<char> closed)
{
  Ledger ledger;
  const auto A = makeDenseOperator(problem.A);
  UnilateralProblem unilateral(*A, problem.constrained, rigidMotions(problem.size(), problem.modes),
                               motionNames(problem.modes), ledger);
  return unilateral.solve(problem.b, problem.bound, std::move(closed));
}

UnilateralState solve(const SampleProblem& problem)
{
  return solve(problem, problem.allClosed());
}

double kktDefect(const SampleProblem& problem, const UnilateralState& state)
{
  const Vector Au = multiply(problem.A, state.u);
  const double forceScale = std::max(largest(problem.b), largest(state.force));
  const double lengthScale = std::max(largest(problem.bound), largest(state.u));
  double defect = 0.0;
  for (std::size_t i = 0; i < Au.size(); ++i) {
    defect = std::max(defect, std::abs(Au[i] - problem.b[i] - state.force[i]) / forceScale);
    const double force = state.force[i] / forceScale, gap = (problem.bound[i] - state.u[i]) / lengthScale;
    if (problem.constrained[i])
      defect = std::max({defect, force, -gap, std::min(std::abs(force), std::abs(gap))});
    else
      defect = std::max(defect, std::abs(force));
  }
  return defect;
}

void expectSame(const UnilateralState& a, const UnilateralState& b, double tolerance)
{
  EXPECT_EQ(a.closed, b.closed);
  ASSERT_EQ(a.u.size(), b.u.size());
  for (std::size_t i = 0; i < a.u.size(); ++i) {
    EXPECT_NEAR(a.u[i], b.u[i], tolerance * largest(b.u)) << "displacement " << i;
    EXPECT_NEAR(a.force[i], b.force[i], tolerance * largest(b.force)) << "force " << i;
  }
}

} // namespace ndframe::test
