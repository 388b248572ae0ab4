// What is not done twice, what threads must not change, and what speed is measured with.

#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "ndframe/assembly/body_loads.hpp"
#include "ndframe/base/log.hpp"
#include "ndframe/driver/deck_spec.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

Outcome withThreads(const char* threads, const Scene& scene)
{
  setenv("OMP_NUM_THREADS", threads, 1);
  Outcome outcome = scene.run();
  unsetenv("OMP_NUM_THREADS");
  return outcome;
}

/// The bound's square, element by element; nothing without a certificate.
std::vector<CellValues> etaOf(const Outcome& outcome)
{
  return outcome.run.certificate ? outcome.run.certificate->etaGlobal : std::vector<CellValues>{};
}

/// A pressure that counts how often its functions are asked for.
class CountingLoad final : public Load
{
public:
  explicit CountingLoad(const Params& params) : Load(params) {}
  std::vector<SampledFunction> functions(int) const override
  {
    ++asked;
    return {{std::make_shared<const ExpressionTree>("x"), {}}};
  }
  void density(int dim, const double* values, const double*, double* q) const override
  {
    for (int k = 0; k < dim; ++k)
      q[k] = -values[0];
  }
  static int asked;
};

int CountingLoad::asked = 0;

std::unique_ptr<Components> componentsWithCounter()
{
  return makeComponents([](Components& c) {
    c.loads.add("Counting", "Counts.", {sideSpec()}, [](const Params& p) { return std::make_unique<CountingLoad>(p); });
  });
}

nlohmann::json yardstickOf(const std::string& deck, const std::vector<std::string>& settings)
{
  const std::string folder = testing::TempDir() + "yardstick-" + deck + "-" + std::to_string(getpid());
  std::vector<std::string> arguments{"--yardstick", "-i", shippedDeck(deck), "--set", "Output/Directory=" + folder};
  for (const auto& setting : settings) {
    arguments.push_back("--set");
    arguments.push_back(setting);
  }
  const auto result = runProgram(arguments, testing::TempDir());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(filesIn(folder), std::vector<std::string>{deck + ".yardstick.json"});
  return nlohmann::json::parse(contentsOf(folder + "/" + deck + ".yardstick.json"));
}

} // namespace

TEST(Speed, ThreadsDoNotChangeABit)
{
  Scene waves("certificate"); // sampled in both bodies
  for (const std::string load : {"Bodies/punch/Loads/weight/", "Bodies/foundation/Loads/weight/"})
    waves.set(load + "Type=Body Force").set(load + "Y=-0.01*sin(8*x)*cos(5*y)");
  std::vector<std::pair<std::string, Scene>> scenes{{"waves", waves}};
  for (const char* deck : {"punch", "contact-loss", "certificate", "beam-3d", "punch-3d"})
    scenes.emplace_back(deck, Scene(deck));
  for (const auto& [deck, scene] : scenes) {
    const auto one = withThreads("1", scene);
    for (const char* threads : {"2", "3", "2"}) {
      const auto several = withThreads(threads, scene);
      EXPECT_EQ(several.run.solved.states.back().tractionDirichlet, one.run.solved.states.back().tractionDirichlet)
          << deck;
      for (std::size_t body = 0; body < one.run.solved.fields.size(); ++body)
        EXPECT_EQ(displacement(several.run, int(body)), displacement(one.run, int(body))) << deck;
      EXPECT_EQ(etaOf(several), etaOf(one)) << deck;
      EXPECT_EQ(several.ledger->counts(), one.ledger->counts()) << deck;
    }
  }
}

TEST(Speed, ALoadIsIntegratedOnceForCheckAndAssembly)
{
  const auto all = componentsWithCounter();
  DeckList text = Scene("punch").deck();
  Diagnostics diagnostics;
  for (const char* setting : {"Bodies/punch/Loads/press/Type=Counting", "Bodies/punch/Loads/press/Side=top"})
    applySetting(text, setting, diagnostics);
  const Params deck = validate(text, makeDeckSpec(*all), diagnostics);
  diagnostics.throwIfAny();
  const Model model = buildModel(readScene(deck), *all);
  const int afterReading = CountingLoad::asked;
  EXPECT_GT(afterReading, 0);
  const auto solver = all->linearSolvers.build(deck.sub("Linear Solver"));
  const auto representation = all->interfaceOperators.build(deck.sub("Interface Operator"));
  Ledger ledger;
  const auto condensed = condense(model, *solver, *representation, Comm::single(), ledger);
  EXPECT_EQ(CountingLoad::asked, afterReading);
  EXPECT_EQ(condensed.systems[0].load.all(), integrateLoads(model.bodies[0]));
}

/// The first sweep of a zero traction has nothing to multiply at all.
TEST(Speed, AContactThatStaysClosedCostsOneProductASweep)
{
  const auto outcome = Scene("punch").run();
  const auto& ledger = *outcome.ledger;
  EXPECT_EQ(ledger.counted("status passes"), ledger.counted("sweeps"));
  EXPECT_EQ(ledger.counted("interface products"), ledger.counted("sweeps") - 1);
}

TEST(Yardstick, IsTheSumOfTheBodies)
{
  const auto result = yardstickOf("punch", {"Bodies/punch/Mesh/Cells={7, 5}", "Bodies/foundation/Mesh/Cells={14, 6}"});
  EXPECT_EQ(result.size(), 3);
  for (const char* key : {"dofs", "nonzeros", "flops"}) {
    EXPECT_GT(result["punch"][key], 0);
    EXPECT_EQ(result["punch"][key].get<double>() + result["foundation"][key].get<double>(), result["all"][key]) << key;
  }
  EXPECT_EQ(result["punch"]["dofs"], 2 * 15 * 11 - 11); // a roller takes a component of eleven nodes
  const auto& all = result["all"];
  const auto seconds = [&](const char* stage) { return all[stage]["wall"].get<double>(); };
  EXPECT_NEAR(seconds("total"), seconds("order") + seconds("factor") + seconds("solve"), 1e-12);
}

TEST(Yardstick, OfOneBodyIsTheSum)
{
  const auto result = yardstickOf("beam-3d", {});
  EXPECT_EQ(result["beam"]["nonzeros"], result["all"]["nonzeros"]);
}

TEST(Yardstick, MeasuresNoStudy)
{
  const auto result = runProgram({"--yardstick", "-i", shippedDeck("study")}, testing::TempDir());
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.err.find("--yardstick measures one scene; run it without a study or load cases."), std::string::npos)
      << result.err;
}
