// NAME.checkpoint: all numbers bit by bit, and what decks differ in.

#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/report/checkpoint_bytes.hpp"

namespace
{

using namespace ndframe;

constexpr double infinity = std::numeric_limits<double>::infinity();

Checkpoint sample()
{
  LevelRecord level;
  level.summary = {2,      48,   6,       0.8,         3, 0.1,  1.0 / 3.0,
                   1e-300, 0.09, "punch", {0.1, -0.0}, 7, 0.25, NumberBracket{-1.0, -0.9}};
  level.lesson.errors = {0.1, 0.01, 1.0 / 3.0, 1e-300, 0.09, 0.0};
  level.lesson.contributions = {{0.1, 5e-324, -0.0}, {}};
  level.lesson.ends = {{0, 3}, {1, 2}};
  level.lesson.brackets = {{{{0.1, -0.0}, {1.0 / 3.0, 0.0}}, 2.5}};
  level.maximumDofs = std::int64_t(1) << 40;
  level.meshes = "0123456789abcdef";
  level.nextTraction = {-1.0 / 7.0, 0.0};
  level.tractionNeumann = {-1.0 / 9.0, 1e300};
  level.closed = {1, 0};
  level.dirichletBodies = {1};
  level.roles = {{{"punch"}, {"foundation"}, true, 0.3, 0.5, 0.6, std::nullopt}};
  level.energy.lower = {-infinity, 0.0, ""};
  level.energy.upper = {-0.8, 1e-17, "level 1"};
  level.energy.certificates = 2;
  Checkpoint checkpoint;
  checkpoint.version = "1.2.3";
  checkpoint.deckJson = "{}";
  checkpoint.levels = {level, LevelRecord()};
  checkpoint.sweeps.emplace();
  SweepsDone& done = checkpoint.sweeps->done;
  done.history.resize(1);
  done.history[0].epsTau = 1.0 / 3.0;
  done.history[0].note = "theta lowered";
  done.state.uDirichlet = ofUnknowns({0.1, -0.0});
  done.state.tractionNeumann = atInterface({-1.0 / 7.0, 5e-324});
  done.state.closed = {1, 0};
  done.traction = atInterface({1e300, 0.1});
  done.relaxation = {{0.5}, {}, {1.0 / 3.0, -0.0}};
  done.counts = {{"sweeps", 20}};
  done.passes.emplace();
  done.passes->first = {1, 1};
  done.passes->closed = {1, 0};
  done.passes->passes = 3;
  done.passes->u = {0.1, 5e-324};
  done.passes->history = {{{1, 0}, {1, 1}}, 4, true, true, 2};
  done.passes->system.fields = {{1.0 / 3.0, -0.0}, {}};
  done.passes->system.levelClosed = {0, 1};
  done.passes->system.tolerance = 1e-3;
  done.passes->counts = {{"status passes", 3}};
  checkpoint.sweeps->goal = 1e-3;
  checkpoint.sweeps->before = 7;
  checkpoint.solution = {{0.1, -0.0}, {}};
  checkpoint.seconds = 1.5;
  checkpoint.firstMemory = 30000000;
  checkpoint.peakMemory = std::int64_t(1) << 35;
  checkpoint.counts = {{"factorisations", 4}, {"sweeps", std::int64_t(1) << 33}};
  checkpoint.stages = {{"read", 0.125, 1000}};
  return checkpoint;
}

void expectSameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

std::string refusalOf(const std::string& bytes)
{
  try {
    checkpointFromBytes(bytes, "a.checkpoint", "1.2.3");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

constexpr const char* deck = R"({"Title": "a", "Bodies": {"punch": {"Young": 1.0}}, "Output": {"Name": "b"},
                                 "Accuracy": {"Target": 0.1, "Maximum Dofs": 5}})";

} // namespace

TEST(CheckpointFile, HoldsAllBitsOfAllNumbers)
{
  const Checkpoint before = sample(), after = checkpointFromBytes(toBytes(before), "", "1.2.3");
  EXPECT_EQ(toBytes(after), toBytes(before));
  ASSERT_EQ(after.levels.size(), 2u);
  const LevelRecord &level = after.levels.front(), &given = before.levels.front();
  ASSERT_EQ(level.lesson.contributions.size(), 2u);
  expectSameBits(level.lesson.contributions[0], given.lesson.contributions[0]);
  expectSameBits(level.nextTraction, given.nextTraction);
  expectSameBits(level.tractionNeumann, given.tractionNeumann);
  expectSameBits(level.summary.worstPoint, given.summary.worstPoint);
  EXPECT_EQ(level.lesson.ends, given.lesson.ends);
  ASSERT_EQ(level.lesson.brackets.size(), 1u);
  expectSameBits(level.lesson.brackets[0].bracket.closed, given.lesson.brackets[0].bracket.closed);
  expectSameBits(level.lesson.brackets[0].bracket.open, given.lesson.brackets[0].bracket.open);
  EXPECT_EQ(level.lesson.brackets[0].length, 2.5);
  EXPECT_EQ(level.lesson.errors.relative, given.lesson.errors.relative);
  EXPECT_EQ(level.maximumDofs, given.maximumDofs);
  EXPECT_EQ(level.energy.lower.value, -infinity);
  EXPECT_EQ(level.summary.energy->lower, -1.0);
  EXPECT_FALSE(after.levels.back().summary.energy.has_value());
  EXPECT_EQ(level.roles.front().dirichletBodies, given.roles.front().dirichletBodies);
  EXPECT_FALSE(level.roles.front().contractionExchanged.has_value());
  EXPECT_EQ(after.counts, before.counts);
  const StatusPasses &passes = *after.sweeps->done.passes, &kept = *before.sweeps->done.passes;
  expectSameBits(passes.u, kept.u);
  expectSameBits(passes.system.fields.front(), kept.system.fields.front());
  EXPECT_EQ(passes.history.seen, kept.history.seen);
}

TEST(CheckpointFile, IsRefusedWhereverItEndsTooEarly)
{
  const std::string bytes = toBytes(sample());
  EXPECT_EQ(refusalOf(bytes), "");
  for (std::size_t length = 1; length < bytes.size(); ++length)
    EXPECT_THAT(refusalOf(bytes.substr(0, length)), testing::HasSubstr("ends too early")) << length;
  EXPECT_THAT(refusalOf(bytes + "x"), testing::HasSubstr("is not an ndframe checkpoint"));
}

TEST(CheckpointFile, TellsWhichParametersDiffer)
{
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(differenceOf(deck, deck), "");
  EXPECT_EQ(differenceOf(changed(deck, "\"b\"", "\"c\""), deck), "");
  EXPECT_EQ(differenceOf(changed(deck, "\"a\"", "\"c\""), deck), "");
  EXPECT_EQ(differenceOf(changed(deck, ": 5", ": 6"), deck), "");
  EXPECT_EQ(differenceOf(changed(deck, "1.0", "2.0"), deck), "Bodies/punch/Young is 2.0 and was 1.0");
  EXPECT_EQ(differenceOf(changed(deck, "1.0", "1.0, \"Poisson\": 0"), deck),
            "Bodies/punch/Poisson is 0 and was not there");
  EXPECT_EQ(differenceOf(deck, changed(deck, "1.0", "1.0, \"Poisson\": 0")),
            "Bodies/punch/Poisson is not there and was 0");
  EXPECT_EQ(differenceOf(changed(changed(deck, "1.0", "2.0"), "0.1", "0.2"), deck),
            "Accuracy/Target is 0.2 and was 0.1, and 1 more");
}
