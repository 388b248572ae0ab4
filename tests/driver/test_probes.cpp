// Output/Probes: values that are known exactly, whatever the mesh, and what is written of them.

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "driver/program_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

namespace
{

const ProbeSummary& probe(const Run& run, const std::string& name)
{
  for (const ProbeSummary& one : run.summary.probes)
    if (one.name == name)
      return one;
  throw std::runtime_error("no probe " + name);
}

/// The deck "patch": blocks of E = 1 and E = 2 under the pressure 1, exact on every mesh.
struct Patch
{
  const char* pattern;
  int order;
  double degrees;
};
void PrintTo(const Patch& p, std::ostream* out)
{
  *out << p.pattern << ", order " << p.order << ", turned by " << p.degrees;
}

/// x turned by the angle.
std::vector<double> turned(double x, double y, double degrees)
{
  const double angle = degrees * M_PI / 180.0;
  return {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y};
}
std::string text(const std::vector<double>& point)
{
  return fmt::format("{{{:.17g}, {:.17g}}}", point[0], point[1]);
}

} // namespace

class ProbesOfAPatch : public testing::TestWithParam<Patch>
{};
INSTANTIATE_TEST_SUITE_P(Meshes, ProbesOfAPatch,
                         testing::Values(Patch{"Right", 1, 0.0}, Patch{"Crossed", 2, 30.0},
                                         Patch{"Alternating", 2, 200.0}, Patch{"Crossed", 1, 77.0}));

TEST_P(ProbesOfAPatch, AreExact)
{
  const auto [pattern, order, degrees] = GetParam();
  Scene scene("patch");
  scene.set("Coupling/Type=Monolithic").set(fmt::format("Discretization/Order={}", order));
  for (const char* body : {"upper", "lower"})
    scene.set(fmt::format("Bodies/{}/Mesh/Pattern={}", body, pattern));
  scene.rotate(degrees);
  scene.set("Output/Probes/middle/Body=upper").set("Output/Probes/middle/At=" + text(turned(0.5, 0.5, degrees)));
  scene.set("Output/Probes/sole/Body=upper").set("Output/Probes/sole/Points=4");
  scene.set("Output/Probes/sole/From=" + text(turned(0.0, 0.0, degrees)));
  scene.set("Output/Probes/sole/To=" + text(turned(1.0, 0.0, degrees)));
  scene.set("Output/Probes/ground/Body=lower").set("Output/Probes/ground/Side=bottom");
  const Outcome outcome = scene.run();
  const PointSummary& middle = probe(outcome.run, "middle").points.front();
  EXPECT_FALSE(middle.contactPressure.has_value());
  const double angle = degrees * M_PI / 180.0, c = std::cos(angle), s = std::sin(angle);
  EXPECT_NEAR(middle.stress[0], -s * s, 1e-11);
  EXPECT_NEAR(middle.stress[1], -c * c, 1e-11);
  EXPECT_NEAR(middle.stress[3], s * c, 1e-11);
  const std::vector<double> moved = turned(0.39 * 0.5, -0.455 - 0.91 * 0.5, degrees); // plane strain, nu = 0.3
  EXPECT_NEAR(middle.displacement[0], moved[0], 1e-11);
  EXPECT_NEAR(middle.displacement[1], moved[1], 1e-11);
  const auto& line = probe(outcome.run, "sole").points;
  ASSERT_EQ(line.size(), 4u);
  for (const PointSummary& point : line) {
    EXPECT_NEAR(point.contactPressure.value(), 1.0, 1e-10);
    EXPECT_NEAR(point.contactGap.value(), 0.0, 1e-11);
  }
  const SideSummary& ground = probe(outcome.run, "ground").side.value();
  const std::vector<double> up = turned(0.0, 1.0, degrees);
  EXPECT_NEAR(ground.measure, 1.0, 1e-14);
  EXPECT_NEAR(ground.force[0], up[0], 1e-11);
  EXPECT_NEAR(ground.force[1], up[1], 1e-11);
  EXPECT_NEAR(ground.moment[0], 0.0, 1e-11);
}

TEST(ProbesOfABeam, FollowTheClosedFormOfPureBending)
{
  Scene scene("beam-3d"); // sigma_xx = y, u = 0.01 (x y, -(x^2 + nu (y^2 - z^2)) / 2, -nu y z)
  scene.set("Output/Probes/across/Body=beam").set("Output/Probes/across/Points=7");
  scene.set("Output/Probes/across/From={1.3, -0.5, 0.1}").set("Output/Probes/across/To={2.9, 0.5, -0.2}");
  scene.set("Output/Probes/root/Body=beam").set("Output/Probes/root/Side=left");
  const Outcome outcome = scene.run();
  for (const PointSummary& point : probe(outcome.run, "across").points) {
    const double x = point.point[0], y = point.point[1], z = point.point[2], k = 0.01, nu = 0.3;
    EXPECT_NEAR(point.stress[0], y, 1e-11);
    EXPECT_NEAR(point.vonMises, std::abs(y), 1e-11);
    EXPECT_NEAR(point.displacement[0], k * x * y, 1e-12);
    EXPECT_NEAR(point.displacement[1], -k * (x * x + nu * (y * y - z * z)) / 2, 1e-12);
    EXPECT_NEAR(point.displacement[2], -k * nu * y * z, 1e-12);
  }
  const SideSummary& root = probe(outcome.run, "root").side.value();
  const double bending = 0.5 * std::pow(1.0, 3) / 12.0; // int y^2 dA
  EXPECT_NEAR(root.force[0], 0.0, 1e-12);
  EXPECT_NEAR(root.moment[2], bending, 1e-12); // n = -e_x, traction -y e_x: M_z = int y^2
}

TEST(ProbesOfAPunch, ConvergeWithTheTarget)
{
  std::vector<double> values;
  for (const char* target : {"0.1", "0.03", "0.01", "0.003"}) {
    Scene scene("punch");
    scene.set("Error Estimation/Estimators={Global}").set(std::string("Accuracy/Target=") + target);
    scene.set("Output/Probes/top/Body=punch").set("Output/Probes/top/Side=top");
    values.push_back(probe(scene.run().run, "top").side->displacement[1]);
  }
  const double before = std::abs(values[1] - values[3]), after = std::abs(values[2] - values[3]);
  EXPECT_LT(after, 0.5 * before);
  EXPECT_LT(after, 1e-3 * std::abs(values[3]));
}

class ProbeFiles : public ProgramFolder
{
protected:
  const std::vector<std::string> probes_{"Output/Probes/tip/Body=punch", "Output/Probes/tip/At={1, 1}",
                                         "Output/Exodus=false", "Output/Contact Table=false"};
  ProgramResult punch(std::vector<std::string> more = {}) const
  {
    more.insert(more.begin(), probes_.begin(), probes_.end());
    return callDeck("punch", more);
  }
};

TEST_F(ProbeFiles, AreWrittenAndNamed)
{
  const auto result = punch();
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(files(), ElementsAre("punch.probes.csv", "punch.summary.json"));
  EXPECT_THAT(result.out, HasSubstr("wrote punch.probes.csv, punch.summary.json"));
  std::istringstream table(contentsOf(path("punch.probes.csv")));
  std::string title, row;
  std::getline(table, title);
  std::getline(table, row);
  EXPECT_THAT(title, HasSubstr("probe,body,side,point,x,y,u_x,u_y,stress_xx"));
  const Json found = summary("punch")["probes"][0];
  EXPECT_THAT(row, HasSubstr(fmt::format("tip,punch,,0,1,1,{:.17g},", found["displacement"][0].get<double>())));
  EXPECT_TRUE(found["contact_pressure"].is_null());
}

TEST_F(ProbeFiles, AreNotWrittenWithoutTheirTable)
{
  EXPECT_EQ(punch({"Output/Probes/Table=false"}).exitCode, 0);
  EXPECT_THAT(files(), ElementsAre("punch.summary.json"));
  EXPECT_EQ(summary("punch")["probes"].size(), 1u);
}

TEST_F(ProbeFiles, OfAnEarlierRunAreRemovedWhereThereIsNoSolution)
{
  punch();
  EXPECT_EQ(punch({"Bodies/punch/Loads/press/Value=-1"}).exitCode, 3);
  EXPECT_THAT(files(), ElementsAre("punch.summary.json"));
  EXPECT_TRUE(summary("punch")["probes"].is_null());
}

TEST_F(ProbeFiles, AreColumnsOfAStudyThatWritesNone)
{
  std::vector<std::string> arguments{"-i", shippedDeck("punch"), "--study", "Bodies/punch/Material/Young Modulus=1; 2"};
  for (const std::string& setting : probes_)
    arguments.insert(arguments.end(), {"--set", setting});
  arguments.insert(arguments.end(), {"--set", "Study/Columns={probes/tip/displacement/1}"});
  const auto result = call(arguments);
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(files(), ElementsAre("punch.study.csv"));
  EXPECT_THAT(contentsOf(path("punch.study.csv")), HasSubstr("probes/tip/displacement/1"));
}

TEST_F(ProbeFiles, KnowTiedPartsByTheirNames)
{
  const std::string deck = std::string(NDFRAME_CASES) + "/tied/tied.xml";
  const auto result = call({deck, "--set", "Output/Probes/top/Body=up", "--set", "Output/Probes/top/Side=top", "--set",
                            "Output/Probes/foot/Body=low", "--set", "Output/Probes/foot/Side=bottom"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const Json probes = summary("tied")["probes"];
  EXPECT_EQ(probes[0]["body"], "low + up");
  EXPECT_EQ(probes[1]["side"], "bottom");
  EXPECT_EQ(probes.size(), 2u);
}

TEST_F(ProbeFiles, RefuseRigidBodies)
{
  const auto result = callDeck("rigid-cylinder", {"Output/Probes/p/Body=cylinder", "Output/Probes/p/At={0, 0}"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("Output/Probes/p: \"cylinder\" is rigid: it has no stress and moves as the deck "
                                    "says; name a body that touches it."));
}
