// What must not matter: units, orientation, numbering, order of the bodies.

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// All histories go the same way, statuses included.
void expectSameHistory(const Run& a, const Run& b)
{
  ASSERT_EQ(a.solved.coupling.history.size(), b.solved.coupling.history.size());
  for (std::size_t s = 0; s < a.solved.coupling.history.size(); ++s) {
    const auto &p = a.solved.coupling.history[s], &q = b.solved.coupling.history[s];
    EXPECT_NEAR(p.epsTau, q.epsTau, 1e-6 * q.epsTau) << "sweep " << s + 1;
    EXPECT_EQ(p.closed, q.closed) << "sweep " << s + 1;
    EXPECT_EQ(p.statusPasses, q.statusPasses) << "sweep " << s + 1;
  }
}

Vector scaled(Vector values, double factor)
{
  for (double& value : values)
    value *= factor;
  return values;
}

Vector turned(const Vector& plane, double degrees)
{
  const double c = std::cos(degrees * M_PI / 180.0), s = std::sin(degrees * M_PI / 180.0);
  Vector result;
  for (std::size_t i = 0; i < plane.size(); i += 2)
    result.insert(result.end(), {c * plane[i] - s * plane[i + 1], s * plane[i] + c * plane[i + 1]});
  return result;
}

struct Way
{
  const char* deck;
  const char* setting;
};

void PrintTo(const Way& way, std::ostream* out)
{
  *out << way.deck << " with " << way.setting;
}

class Invariance : public testing::TestWithParam<Way>
{
protected:
  static Scene scene() { return Scene(GetParam().deck).set(GetParam().setting); }
};

/// Displacements of a body by the position of the nodes.
std::map<std::pair<double, double>, std::pair<double, double>> byPosition(const Run& run, int body)
{
  const auto& nodes = run.model.bodies[std::size_t(body)].nodes;
  const Vector& u = displacement(run, body);
  std::map<std::pair<double, double>, std::pair<double, double>> all;
  for (int i = 0; i < nodes.numNodes(); ++i)
    all[{nodes.point(i)[0], nodes.point(i)[1]}] = {u[std::size_t(2 * i)], u[std::size_t(2 * i + 1)]};
  return all;
}

/// The mesh with its nodes and its elements in another order and with other numbers (format 2.2).
std::string renumbered(const std::string& msh)
{
  std::istringstream in(msh);
  std::string line, out;
  std::mt19937 generator(7);
  const auto section = [&](const auto& renumber) {
    std::getline(in, line);
    out += line + "\n";
    std::vector<std::string> lines(std::stoul(line));
    for (auto& l : lines) {
      std::getline(in, l);
      std::istringstream numbers(l);
      l = renumber(std::vector<std::string>{std::istream_iterator<std::string>(numbers), {}});
    }
    std::shuffle(lines.begin(), lines.end(), generator);
    for (const auto& l : lines)
      out += l + "\n";
  };
  const auto another = [](const std::string& node) { return std::to_string(10007 - 3 * std::stoi(node)); };
  const auto joined = [](const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); };
  while (std::getline(in, line)) {
    out += line + "\n";
    if (line == "$Nodes")
      section([&](std::vector<std::string> words) {
        words[0] = another(words[0]);
        return joined(words);
      });
    if (line == "$Elements")
      section([&](std::vector<std::string> words) {
        for (std::size_t k = 3 + std::stoul(words[2]); k < words.size(); ++k)
          words[k] = another(words[k]);
        return joined(words);
      });
  }
  return out;
}

} // namespace

TEST_P(Invariance, UnderAChangeOfUnits)
{
  const auto reference = scene().run();
  for (const auto& [length, stress] : {std::pair(1e3, 1e9), {1e-3, 1e-9}, {1e3, 1e-9}, {1e-3, 1e9}}) {
    const auto outcome = scene().changeUnits(length, stress).run();
    expectSameHistory(outcome.run, reference.run);
    EXPECT_EQ(statuses(outcome.run), statuses(reference.run));
    for (int body = 0; body < 2; ++body)
      EXPECT_LT(relativeDifference(displacement(outcome.run, body), scaled(displacement(reference.run, body), length)),
                1e-9);
    EXPECT_LT(relativeDifference(traction(outcome.run), scaled(traction(reference.run), stress)), 1e-8);
    EXPECT_NEAR(outcome.run.summary.energy / (reference.run.summary.energy * stress * length * length), 1.0, 1e-10);
    EXPECT_LT(outcome.run.summary.residuals.equilibrium, 1e-10);
  }
}

TEST_P(Invariance, UnderARotationOfTheScene)
{
  const auto reference = scene().run();
  Scene rotated = scene();
  rotated.rotate(30.0).changeAll("Gap", [](const std::string&) {
    return fmt::format("0.5 * ({:.17g} * x + {:.17g} * y)^2", std::cos(M_PI / 6), std::sin(M_PI / 6));
  });
  const auto outcome = rotated.run();
  expectSameHistory(outcome.run, reference.run);
  EXPECT_EQ(statuses(outcome.run), statuses(reference.run));
  for (int body = 0; body < 2; ++body)
    EXPECT_LT(relativeDifference(displacement(outcome.run, body), turned(displacement(reference.run, body), 30.0)),
              1e-9);
  EXPECT_LT(relativeDifference(traction(outcome.run), traction(reference.run)), 1e-8);
  EXPECT_NEAR(outcome.run.summary.energy / reference.run.summary.energy, 1.0, 1e-10);
}

TEST_P(Invariance, UnderAnotherOrderOfTheBodies)
{
  const auto reference = scene().run(), outcome = scene().reverseBodies().run();
  EXPECT_EQ(outcome.run.model.bodies[0].name, reference.run.model.bodies[1].name);
  expectSameHistory(outcome.run, reference.run);
  for (int body = 0; body < 2; ++body)
    EXPECT_LT(relativeDifference(displacement(outcome.run, 1 - body), displacement(reference.run, body)), 1e-9);
  EXPECT_LT(relativeDifference(traction(outcome.run), traction(reference.run)), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Decks, Invariance,
                         testing::Values(Way{"punch", "Coupling/Type=Neumann-Dirichlet"},
                                         Way{"punch", "Coupling/Relaxation/Type=Aitken"},
                                         Way{"contact-loss", "Coupling/Type=Neumann-Dirichlet"},
                                         Way{"contact-loss", "Coupling/Initial Traction=Balanced"},
                                         Way{"contact-loss", "Coupling/Type=Monolithic"},
                                         Way{"hertz", "Coupling/Type=Neumann-Dirichlet"},
                                         Way{"hertz", "Coupling/Type=Monolithic"}));

TEST(Numbering, OfAMeshFileDoesNotMatter)
{
  const TemporaryFolder folder;
  const std::string shipped = std::string(NDFRAME_DECKS) + "/meshes/punch-foundation-2.2.msh";
  writeFile(folder.file("renumbered.msh"), renumbered(contentsOf(shipped)));
  const auto with = [](const std::string& file) {
    Scene scene("gmsh-msh2");
    scene.set("Coupling/Type=Neumann-Dirichlet").set("Coupling/Stopping/Tolerance=1e-6");
    return scene.set("Bodies/punch/Mesh/File=" + file).set("Bodies/foundation/Mesh/File=" + file).run();
  };
  const auto reference = with(shipped), outcome = with(folder.file("renumbered.msh"));
  EXPECT_NE(outcome.run.model.bodies[0].mesh.points, reference.run.model.bodies[0].mesh.points);
  expectSameHistory(outcome.run, reference.run);
  for (int body = 0; body < 2; ++body) {
    const auto expected = byPosition(reference.run, body), found = byPosition(outcome.run, body);
    ASSERT_EQ(found.size(), expected.size());
    for (auto a = found.begin(), b = expected.begin(); a != found.end(); ++a, ++b) {
      EXPECT_EQ(a->first, b->first);
      EXPECT_NEAR(a->second.first, b->second.first, 1e-10);
      EXPECT_NEAR(a->second.second, b->second.second, 1e-10);
    }
  }
}

/// The roles of the bodies change the iteration; its limit stays, with n_c turned round.
TEST(Roles, DoNotMatterToTheMonolithicSolution)
{
  const auto reference = Scene("contact-loss").set("Coupling/Type=Monolithic").run();
  const auto outcome = Scene("contact-loss")
                           .set("Coupling/Type=Monolithic")
                           .set("Interfaces/contact/Dirichlet Body=lower")
                           .set("Interfaces/contact/Dirichlet Side=contact")
                           .set("Interfaces/contact/Neumann Body=upper")
                           .set("Interfaces/contact/Neumann Side=bottom")
                           .run();
  for (int body = 0; body < 2; ++body)
    EXPECT_LT(relativeDifference(displacement(outcome.run, body), displacement(reference.run, body)), 1e-9);
  EXPECT_EQ(outcome.run.summary.interfaces[0].closedNodes, reference.run.summary.interfaces[0].closedNodes);
}
