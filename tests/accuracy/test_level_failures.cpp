// Runs with a target of which a level fails, in any way and anywhere: what they end with.

#include <cmath>
#include <new>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "accuracy/failing_components.hpp"
#include "driver/program_folder.hpp"
#include "driver/scene.hpp"
#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/base/ledger.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/report/summary_text.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

namespace
{

struct Way
{
  const char* name;
  std::function<void()> fail;
  const char* words; ///< that the run ends with
  bool isBug = false;
};

const std::vector<Way>& ways()
{
  static const std::vector<Way> all{
      {"not converged", [] { throw NotConverged("no equilibrium"); }, "no equilibrium"},
      {"singular", [] { throw SingularBody("a free motion", 0); }, "a free motion"},
      {"refused", [] { throw InputError("gmsh cannot mesh"); }, "gmsh cannot mesh"},
      {"out of memory", [] { throw std::bad_alloc(); }, "needs more memory"},
      {"a bug", [] { throw std::runtime_error("index out of range"); }, "index out of range", true}};
  return all;
}

/// "SETTING=Failing" makes the component of this kind fail.
struct Place
{
  const char* name;
  const char* setting;
};

Run runWith(const char* setting, const PlannedFailure& plan)
{
  const Components& components = failingComponents(plan);
  Scene scene("punch");
  scene.set("Accuracy/Target=0.05").set("Error Estimation/Estimators={Global}").set(setting);
  Diagnostics diagnostics;
  const Params deck = validate(scene.deck(), makeDeckSpec(components), diagnostics);
  diagnostics.throwIfAny();
  Ledger ledger;
  return runDeck(deck, components, Comm::single(), ledger, silentLog());
}

class LevelFailure : public testing::TestWithParam<Place>
{
protected:
  static constexpr int never = 0;

  static int levels()
  {
    static const int count = int(runWith(GetParam().setting, {never, [] {}}).summary.accuracy->levels.size());
    return count;
  }
};

/// What must hold of a run of which the level `failed` has failed.
void expectTheLevelsBefore(const Run& run, int failed, const Way& way)
{
  const AccuracySummary& accuracy = *run.summary.accuracy;
  EXPECT_FALSE(accuracy.reached);
  EXPECT_THAT(accuracy.limit, HasSubstr(way.words));
  ASSERT_EQ(int(accuracy.levels.size()), failed - 1);
  EXPECT_EQ(accuracy.written, failed - 1);
  EXPECT_TRUE(run.summary.solved);
  EXPECT_EQ(run.failure, "");
  EXPECT_EQ(run.bug.empty(), !way.isBug);
  ASSERT_TRUE(run.summary.errors.has_value());
  EXPECT_TRUE(run.summary.errors->guaranteed);
  EXPECT_NEAR(run.summary.errors->global->absolute, accuracy.answer().bound, 1e-9 * accuracy.answer().bound);
  EXPECT_EQ(run.model.totalDofs(), accuracy.answer().dofs);
  EXPECT_TRUE(std::isfinite(run.summary.energy));
}

} // namespace

TEST_P(LevelFailure, OnALaterLevelLeavesTheLevelsBeforeAndTheBestAnswer)
{
  ASSERT_GE(levels(), 3);
  for (const Way& way : ways())
    for (const int level : {2, levels()}) {
      SCOPED_TRACE(std::string(way.name) + " on level " + std::to_string(level));
      expectTheLevelsBefore(runWith(GetParam().setting, {level, way.fail}), level, way);
    }
}

INSTANTIATE_TEST_SUITE_P(Everywhere, LevelFailure,
                         testing::Values(Place{"Mesh", "Accuracy/Refinement/Type=Failing"},
                                         Place{"Factor", "Linear Solver/Type=Failing"},
                                         Place{"Certificate", "Error Estimation/Recovery/Type=Failing"}),
                         [](const auto& place) { return std::string(place.param.name); });

TEST(FirstLevelFailure, OfTheProblemIsTheAnswer)
{
  for (const char* setting : {"Linear Solver/Type=Failing", "Error Estimation/Recovery/Type=Failing"}) {
    const ndframe::Run run = runWith(setting, {1, [] { throw NotConverged("no equilibrium"); }});
    EXPECT_THAT(run.failure, HasSubstr("no equilibrium"));
    EXPECT_TRUE(run.summary.accuracy->levels.empty());
    EXPECT_EQ(run.summary.accuracy->written, 0);
    EXPECT_FALSE(run.summary.errors.has_value());
    EXPECT_THAT(toJson(run.summary), HasSubstr("\"levels\": []"));
  }
}

TEST(FirstLevelFailure, OfTheUserOrTheMachineEndsTheRun)
{
  EXPECT_THROW(runWith("Linear Solver/Type=Failing", {1, [] { throw InputError("too large"); }}), InputError);
  EXPECT_THROW(runWith("Linear Solver/Type=Failing", {1, [] { throw std::bad_alloc(); }}), std::bad_alloc);
}

class UndecidedFirstLevel : public ProgramFolder
{};

TEST_F(UndecidedFirstLevel, IsNotConverged)
{
  std::string deck = contentsOf(shippedDeck("punch"));
  deck = replacedOnce(deck, "value=\"Pressure\"", "value=\"Traction\"");
  deck = replacedOnce(
      deck,
      "<Parameter name=\"Value\" type=\"double\" value=\"1.0\"/>\n        </ParameterList>\n      </ParameterList>",
      "<Parameter name=\"X\" type=\"double\" value=\"0.1\"/>\n        </ParameterList>\n      </ParameterList>");
  writeFile(path("punch.xml"), deck);
  const auto result = call({"-i", "punch.xml", "--set", "Accuracy/Target=0.02"});
  EXPECT_EQ(result.exitCode, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("contact is undecided"));
  EXPECT_TRUE(summary("punch")["accuracy"]["levels"].empty());
  EXPECT_EQ(summary("punch")["accuracy"]["reached"], false);
}
