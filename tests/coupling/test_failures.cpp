#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::HasSubstr;

namespace
{

/// A stored operator whose inverses give up after some solves in all.
class TiresOut final : public SymmetricOperator
{
public:
  TiresOut(DenseMatrix A, int solves) : A_(makeDenseOperator(std::move(A))), left_(std::make_shared<int>(solves)) {}
  int size() const override { return A_->size(); }
  Vector apply(const Vector& x) const override { return A_->apply(x); }
  const DenseMatrix* dense() const override { return A_->dense(); }
  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override
  {
    return std::make_unique<Inverse>(A_->inverseOn(isFree, shift), left_);
  }

private:
  struct Inverse final : RestrictedInverse
  {
    Inverse(std::unique_ptr<RestrictedInverse> exact, std::shared_ptr<int> solves)
        : inverse(std::move(exact)), left(std::move(solves))
    {}
    Vector solve(const Vector& b) const override
    {
      if ((*left)-- == 0)
        throw NotConverged("tired out");
      return inverse->solve(b);
    }
    std::unique_ptr<RestrictedInverse> inverse;
    std::shared_ptr<int> left;
  };
  std::unique_ptr<SymmetricOperator> A_;
  std::shared_ptr<int> left_;
};

/// The patch, whose body number `body` can be solved only so often.
InterfaceSystem tiringPatch(std::size_t body, int solves)
{
  auto system = patchSystem();
  system.bodies[body].S = std::make_shared<TiresOut>(*system.bodies[body].S->dense(), solves);
  return system;
}

/// One node: a body of stiffness `ratio` over one of stiffness 1, pressed together.
InterfaceSystem springs(double ratio)
{
  InterfaceSystem system = emptySystem(2);
  DenseMatrix S1(2, 2), S2(2, 2);
  for (int i = 0; i < 2; ++i) {
    S1(i, i) = ratio;
    S2(i, i) = 1.0;
  }
  system.bodies.push_back(makeBody({0, 1}, true, S1, {1.0, 1.0}));
  system.bodies.push_back(makeBody({0, 1}, false, S2, {0.0, 0.0}));
  return system;
}

std::string theta(double value)
{
  return relaxation("Constant", "Theta", value);
}

} // namespace

TEST(CouplingFailures, MaximumSweepsReturnsTheLastStateAndTheHistory)
{
  const auto system = patchSystem();
  const auto result = run(*neumannDirichlet(1e-8, {}, 6), system);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.history.size(), 6u);
  EXPECT_THAT(result.reason, HasSubstr("has not fallen below 1e-08 in 6 sweeps (Maximum Sweeps)"));
  expectEquilibrium(system, result.state);
}

TEST(CouplingFailures, ALaterSweepThatFailsReturnsTheSweepBefore)
{
  for (const std::size_t body : {0, 1}) {
    const auto result = run(*neumannDirichlet(1e-8), tiringPatch(body, 3));
    const auto three = run(*neumannDirichlet(1e-8, {}, 3), patchSystem());
    EXPECT_FALSE(result.converged);
    EXPECT_EQ(result.reason, "tired out");
    EXPECT_EQ(result.history.size(), 3u);
    expectSameState(result.state, three.state, 1e-15);
  }
}

TEST(CouplingFailures, FirstSweepThatFailsHasNothingToReturn)
{
  EXPECT_THROW(run(*neumannDirichlet(1e-8), tiringPatch(0, 0)), NotConverged);
  EXPECT_THROW(run(*neumannDirichlet(1e-8), tiringPatch(1, 0)), NotConverged);
}

TEST(CouplingFailures, BodyThatIsPulledOffIsNamed)
{
  auto system = patchSystem();
  for (double& g : system.bodies[0].g)
    g = -g;
  for (const char* type : {"Neumann-Dirichlet", "Monolithic"})
    try {
      run(*makeCoupling(text("Type", type)), system);
      ADD_FAILURE() << type;
    } catch (const NotConverged& failure) {
      EXPECT_THAT(failure.what(), HasSubstr("nothing stops translation along y"));
    }
}

TEST(CouplingFailures, ThetaTooLargeForTheStiffnessRatioNamesTheta)
{
  // Below 1 the iteration jumps to and fro, above it grows without bound.
  const auto jumping = run(*neumannDirichlet(1e-3, theta(0.9)), springs(100.0));
  EXPECT_FALSE(jumping.converged);
  EXPECT_THAT(jumping.reason,
              AllOf(HasSubstr("hardly falls"), HasSubstr("a smaller Theta, Coupling/Relaxation/Type = Automatic")));
  const auto growing = run(*neumannDirichlet(1e-3, theta(1.9)), springs(100.0));
  EXPECT_FALSE(growing.converged);
  EXPECT_LT(growing.history.size(), 100u);
  EXPECT_THAT(growing.reason,
              AllOf(HasSubstr("diverges"), HasSubstr("a smaller Theta, Coupling/Relaxation/Type = Automatic")));
}

TEST(CouplingFailures, TheAdviceHelps)
{
  EXPECT_TRUE(run(*neumannDirichlet(1e-3, theta(0.01)), springs(100.0)).converged);
  EXPECT_TRUE(run(*neumannDirichlet(1e-3, relaxation("Aitken", "Initial Theta", 0.5)), springs(100.0)).converged);
}

TEST(CouplingFailures, StatusMethodThatCyclesIsNoted)
{
  // The matrix on which changing all statuses at once comes back (see the tests of the status method), over a body
  // that hardly moves.
  InterfaceSystem system = emptySystem(4);
  const double entries[4][4] = {{23, -14, -9, 8}, {-14, 50, 47, -22}, {-9, 47, 51, -25}, {8, -22, -25, 16}};
  DenseMatrix S1(4, 4), S2(4, 4);
  for (int i = 0; i < 4; ++i) {
    S2(i, i) = 1e6;
    for (int j = 0; j < 4; ++j)
      S1(i, j) = entries[i][j];
  }
  system.bodies.push_back(makeBody({0, 1, 2, 3}, true, S1, {-5.0, 5.0, 9.0, -6.0}));
  system.bodies.push_back(makeBody({0, 1, 2, 3}, false, S2, Vector(4, 0.0)));
  const auto result = run(*neumannDirichlet(1e-6), system);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.history.front().note, "the status method cycled; finished one node at a time");
  EXPECT_EQ(result.history.back().note, "");
}

TEST(CouplingFailures, ABodyWithBothRolesIsABugForTheAlternatingMethod)
{
  auto system = patchSystem();
  system.bodies[1].roles[2] = ContactRole::Dirichlet;
  EXPECT_THROW(run(*neumannDirichlet(1e-3), system), InternalError);
}
