#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "admissibility/sample_chains.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/admissibility/sign_conditions.hpp"
#include "traction_step.hpp"

namespace ndframe
{

namespace
{

constexpr int degree = 2, modes = degree + 1;

/// The vertex between two facets of a straight interface; forces and moments about it in balance.
struct Vertex
{
  explicit Vertex(unsigned seed, Vector nodal = {-1.0, -0.2, 0.0, -0.5, -0.05})
      : random(seed), chain(test::straightChain({0.6, 0.3}, 2)),
        traction(tractionFromNodes(chain.patches, nodal, 2, degree)), E(2, 2 * modes), H(2 * modes, 2 * modes),
        h(random.vector(2 * modes))
  {
    E(0, 0) = E(0, modes) = 1.0; // resultants
    E(1, 0) = 0.5 * 0.6, E(1, modes) = -0.5 * 0.3;
    E(1, 1) = -0.6 * linearArm(), E(1, modes + 1) = -0.3 * linearArm(); // about the end of one, the start of the other
    DenseMatrix R(2 * modes, 2 * modes);
    for (int i = 0; i < 4 * modes * modes; ++i)
      R.data()[i] = random();
    H = multiplyTransposed(R, R);
    for (int i = 0; i < 2 * modes; ++i)
      H(i, i) += 0.5;
  }

  /// Mean of lambda_1 times the linear mode.
  static double linearArm()
  {
    double L[modes];
    const double end[2] = {0.0, 1.0};
    facetBasis(2, degree).values(end, L);
    return L[1] / 6.0;
  }

  TractionStep step() const { return TractionStep({{0, 1}, {1, 0}}, E, H, h); }
  double objective(const Vector& dt) const { return 0.5 * dot(dt, multiply(H, dt)) + dot(h, dt); }

  test::Random random;
  test::Chain chain;
  ContactTraction traction;
  DenseMatrix E, H;
  Vector h;
};

} // namespace

TEST(TractionStep, LowersTheObjectiveAndKeepsTheTractionAdmissibleAndBalanced)
{
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Vertex vertex(seed);
    const ContactTraction before = vertex.traction;
    const Vector dt = vertex.step().apply(vertex.traction);
    EXPECT_LE(vertex.objective(dt), 0.0);
    EXPECT_LT(largestSign(vertex.traction, vertex.chain.patches), 1e-13);
    EXPECT_LT(norm(multiply(vertex.E, dt)), 1e-14);
    for (std::size_t i = 0; i < dt.size();
         ++i) // the vertex's own shares: second of the first facet, first of the other
      EXPECT_DOUBLE_EQ(vertex.traction.shares[modes + i], before.shares[modes + i] + dt[i]);
  }
}

TEST(TractionStep, NoAdmissibleBalancedChangeIsBetter)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Vertex vertex(seed);
    const ContactTraction before = vertex.traction;
    const Vector dt = vertex.step().apply(vertex.traction);
    const double least = vertex.objective(dt);
    const DenseMatrix balanced = nullSpace(vertex.E, 1e-12);
    for (int trial = 0; trial < 200; ++trial) {
      Vector other = multiply(balanced, vertex.random.vector(std::size_t(balanced.cols())));
      ContactTraction changed = before;
      for (std::size_t i = 0; i < other.size(); ++i)
        changed.shares[modes + i] += other[i] = dt[i] + 0.05 * other[i];
      if (largestSign(changed, vertex.chain.patches) <= 0.0) {
        EXPECT_GE(vertex.objective(other), least - 1e-14);
      }
    }
  }
}

TEST(TractionStep, TheNextStepFindsNothingLeftToDo)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Vertex vertex(seed);
    TractionStep step = vertex.step();
    const double first = norm(step.apply(vertex.traction));
    EXPECT_LT(norm(step.apply(vertex.traction)), 1e-7 * first); // the objective is flat there
  }
}

TEST(TractionStep, ATractionFreeVertexStaysFree)
{
  Vertex vertex(1, Vector(5, 0.0));
  vertex.traction.shares[0] = 1e-18; // what projection may leave
  vertex.step().apply(vertex.traction);
  EXPECT_LT(std::abs(*std::max_element(vertex.traction.shares.begin(), vertex.traction.shares.end())), 1e-15);
}

TEST(TractionStep, RowsEmptiedBySupportsOrDirectionsAskForNothing)
{
  Vertex vertex(2);
  Vertex other = vertex;
  other.E = DenseMatrix(5, 2 * modes);
  for (int j = 0; j < 2 * modes; ++j) {
    other.E(1, j) = vertex.E(0, j), other.E(2, j) = -vertex.E(1, j), other.E(3, j) = vertex.E(0, j);
    other.E(4, j) = 1e-16 * vertex.random();
  }
  const Vector dt = vertex.step().apply(vertex.traction), same = other.step().apply(other.traction);
  for (std::size_t i = 0; i < dt.size(); ++i)
    EXPECT_NEAR(same[i], dt[i], 1e-13);
}

} // namespace ndframe
