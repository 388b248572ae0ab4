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
}

TEST(EndOfProgress, FewCellsMoreEachTimeAreNoProgressEither)
{
  EXPECT_EQ(endAfter({{100, 0.2}, {101, 0.2}, {102, 0.2}, {103, 0.2}, {104, 0.2}, {105, 0.2}}), "");
  EXPECT_EQ(endAfter({{100, 0.2}, {101, 0.2}, {102, 0.2}, {103, 0.2}, {104, 0.2}, {105, 0.2}, {106, 0.2}}), stalled);
}
