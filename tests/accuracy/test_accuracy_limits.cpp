// When a run with a target gives up.

#include "accuracy_limits.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

using namespace ndframe;

namespace
{

/// Of levels with these dofs and bounds, after sweeps that came to their end.
std::string endAfter(const std::vector<std::pair<int, double>>& dofsAndBounds)
{
  std::vector<LevelSummary> levels;
  for (const auto& [dofs, bound] : dofsAndBounds) {
    LevelSummary level;
    level.dofs = dofs;
    level.bound = level.relative = bound;
    levels.push_back(level);
  }
  AccuracyOptions options;
  options.maximumLevels = 20;
  CouplingResult coupling;
  coupling.converged = true;
  return endOfProgress(options, levels, coupling);
}

constexpr const char* stalled = "the bound no longer falls with the mesh";

} // namespace

TEST(EndOfProgress, ABoundThatDoesNotFollowTheMesh)
{
  EXPECT_EQ(endAfter({{100, 0.2}, {200, 0.199}, {400, 0.198}}), stalled);
  EXPECT_EQ(endAfter({{100, 0.2}, {200, 0.3}, {400, 0.25}}), stalled);
  EXPECT_EQ(endAfter({{100, 1.0}, {200, 2e-9}, {400, 2e-9}, {800, 2e-9}}), std::string(stalled) + ": round-off");
}

TEST(EndOfProgress, ASpikeIsNone)
{
  EXPECT_EQ(endAfter({{100, 0.2}, {200, 0.25}, {400, 0.15}}), "");
  EXPECT_EQ(endAfter({{100, 0.2}, {200, 0.1}, {400, 0.11}}), "");
}

TEST(EndOfProgress, MeshesOfAFewCellsMoreMayHaveALargerBound)
{
  EXPECT_EQ(endAfter({{4328, 0.069}, {4746, 0.0571}, {4778, 0.0535}, {4898, 0.0581}}), ""); // decks/flange.xml to 5 %
  EXPECT_EQ(endAfter({{4746, 0.0571}, {4778, 0.0535}, {4898, 0.0581}}), "");
  // a round body on two triangles, to 10 %: the next level, of 258 dofs, reaches it
  EXPECT_EQ(endAfter({{146, 0.191}, {160, 0.131}, {190, 0.125}, {220, 0.13}}), "");
  EXPECT_EQ(endAfter({{110, 0.131}, {190, 0.13}, {220, 0.13}}), stalled);
}

TEST(EndOfProgress, ATargetThatIsReachedWithoutTheGuaranteeThatALevelBeforeHad)
{
  std::vector<LevelSummary> levels(2);
  levels[0].bound = levels[0].relative = 0.055;
  levels[1].bound = levels[1].relative = 0.026;
  levels[1].doubt = "forces are out of balance";
  AccuracyOptions options;
  options.target = 0.05;
  options.maximumLevels = 20;
  const auto end = [&] { return endOfProgress(options, levels, {}); };
  EXPECT_EQ(end(), "level 2 reaches it without a guarantee: forces are out of balance");
  EXPECT_TRUE(lostGuarantee(levels));
  EXPECT_TRUE(isBetter(levels[0], levels[1]));

  levels[1].bound = levels[1].relative = 0.051; // the next one may have it again
  EXPECT_EQ(end(), "");

  levels[0].doubt = levels[1].doubt; // there never was one
  levels[1].bound = levels[1].relative = 0.026;
  EXPECT_EQ(end(), "");
  EXPECT_FALSE(lostGuarantee(levels));
  EXPECT_TRUE(isBetter(levels[1], levels[0]));
}

TEST(EndOfProgress, FewCellsMoreEachTimeAreNoProgressEither)
{
  EXPECT_EQ(endAfter({{100, 0.2}, {101, 0.2}, {102, 0.2}, {103, 0.2}, {104, 0.2}, {105, 0.2}}), "");
  EXPECT_EQ(endAfter({{100, 0.2}, {101, 0.2}, {102, 0.2}, {103, 0.2}, {104, 0.2}, {105, 0.2}, {106, 0.2}}), stalled);
}
