// Uniform compression: the exact solution is linear, so every mesh, order, rotation and hypothesis gives it to
// round-off.

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"
#include "ndframe/assembly/fields.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// eps_tau of sweep p when theta = 0.5, the start is zero and only the resultant has to build up.
double closedForm(int sweep)
{
  return std::pow(2.0, 1 - sweep) / (1.0 - std::pow(2.0, -sweep));
}

/// Strains under the pressure 1 along y; shrink is positive.
struct Strain
{
  double widen = 0.0, shrink = 0.0, outOfPlaneStress = 0.0;
};

/// The exact fields of the deck "patch": blocks of E = 1 and E = 2, the lower one on a roller, both on a roller at x =
/// 0.
void expectExactFields(const Run& run, const std::array<Strain, 2>& strains, double degrees)
{
  const double angle = degrees * M_PI / 180.0, c = std::cos(angle), s = std::sin(angle);
  for (std::size_t b = 0; b < 2; ++b) {
    const auto& body = run.model.bodies[b];
    const Strain& strain = strains[b];
    Vector exact;
    for (int i = 0; i < body.nodes.numNodes(); ++i) {
      const auto p = body.nodes.point(i);
      const double x = c * p[0] + s * p[1], y = c * p[1] - s * p[0];
      const double ux = strain.widen * x;
      const double uy = b == 0 ? -strains[1].shrink - strain.shrink * y : -strain.shrink * (y + 1.0);
      exact.insert(exact.end(), {c * ux - s * uy, s * ux + c * uy});
    }
    EXPECT_LT(relativeDifference(displacement(run, int(b)), exact), 1e-11) << body.name;
    for (const auto& stress : cellStress(body, displacement(run, int(b)))) {
      const std::array<double, 6> expected{-s * s, -c * c, strain.outOfPlaneStress, s * c, 0.0, 0.0};
      for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(stress[k], expected[k], 1e-10) << body.name;
    }
  }
  for (const auto& node : run.solved.contact) {
    EXPECT_NEAR(node.tractionDirichlet, -1.0, 1e-10);
    EXPECT_NEAR(node.gap, 0.0, 1e-11);
  }
}

std::array<Strain, 2> planeStrain(double E1 = 1.0, double E2 = 2.0)
{
  const double nu = 0.3;
  return {Strain{nu * (1 + nu) / E1, (1 - nu * nu) / E1, -nu}, Strain{nu * (1 + nu) / E2, (1 - nu * nu) / E2, -nu}};
}

/// Both give the solution in one sweep.
constexpr const char* balanced = "Coupling/Initial Traction=Balanced";
constexpr const char* together = "Coupling/Type=Monolithic";

struct PatchCase
{
  const char* pattern;
  int order;
  double degrees;
  const char* coupling;
};

void PrintTo(const PatchCase& c, std::ostream* out)
{
  *out << c.pattern << ", order " << c.order << ", " << c.degrees << " degrees, " << c.coupling;
}

class Patch : public testing::TestWithParam<PatchCase>
{
protected:
  static Scene blocks()
  {
    Scene scene("patch");
    scene.changeAll("Pattern", [](const std::string&) { return GetParam().pattern; }).rotate(GetParam().degrees);
    return scene.set(fmt::format("Discretization/Order={}", GetParam().order));
  }
  static Scene scene() { return blocks().set(GetParam().coupling); }
};

void setBoth(Scene& scene, const std::string& setting)
{
  scene.set("Bodies/upper/" + setting).set("Bodies/lower/" + setting);
}

} // namespace

TEST_P(Patch, IsExactInPlaneStrain)
{
  const auto outcome = scene().run();
  expectExactFields(outcome.run, planeStrain(), GetParam().degrees);
  EXPECT_EQ(outcome.run.solved.coupling.history.size(), 1U);
}

TEST_P(Patch, IsExactInPlaneStress)
{
  Scene planeStress = scene();
  setBoth(planeStress, "Material/Hypothesis=Plane Stress");
  expectExactFields(planeStress.run().run, {Strain{0.3, 1.0, 0.0}, Strain{0.15, 0.5, 0.0}}, GetParam().degrees);
}

/// Axis 1 along the pressure (the material turns with the scene): eps_1 = -1/E1, eps_2 = nu12/E1.
TEST_P(Patch, IsExactWithAnOrthotropicLaw)
{
  Scene orthotropic = scene();
  setBoth(orthotropic, "Material/Type=Orthotropic");
  for (const char* entry : {"Young Modulus 1=4", "Young Modulus 2=2", "Young Modulus 3=3", "Poisson Ratio 12=0.3",
                            "Poisson Ratio 13=0.2", "Poisson Ratio 23=0.1", "Shear Modulus 12=1", "Shear Modulus 13=1",
                            "Shear Modulus 23=1", "Hypothesis=Plane Stress"})
    setBoth(orthotropic, fmt::format("Material/{}", entry));
  setBoth(orthotropic, fmt::format("Material/Angle={}", GetParam().degrees + 90.0));
  expectExactFields(orthotropic.run().run, {Strain{0.3 / 4, 0.25, 0.0}, Strain{0.3 / 4, 0.25, 0.0}},
                    GetParam().degrees);
}

TEST_P(Patch, BuildsTheTractionUpByTheClosedForm)
{
  const auto outcome = blocks().run();
  ASSERT_EQ(outcome.run.solved.coupling.history.size(), 28U);
  for (const auto& record : outcome.run.solved.coupling.history) {
    EXPECT_NEAR(record.epsTau, closedForm(record.sweep), 1e-11) << record.sweep;
    EXPECT_NEAR(record.forceNeumann, std::pow(2.0, 1 - record.sweep) - 1.0, 1e-11) << record.sweep;
    EXPECT_EQ(record.open, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Patch,
                         testing::Values(PatchCase{"Right", 1, 0.0, balanced},
                                         PatchCase{"Alternating", 2, 30.0, balanced},
                                         PatchCase{"Crossed", 1, 30.0, together},
                                         PatchCase{"Crossed", 2, 30.0, balanced}, PatchCase{"Right", 2, 0.0, together},
                                         PatchCase{"Alternating", 1, 200.0, together}));

TEST(PatchDeck, StopsAfterTheSweepsOfTheClosedForm)
{
  const std::array<std::pair<const char*, int>, 6> sweeps{
      {{"0.2", 4}, {"0.1", 5}, {"1e-2", 8}, {"1e-3", 11}, {"1e-4", 15}, {"1e-8", 28}}};
  for (const auto& [tolerance, expected] : sweeps) {
    const auto outcome = Scene("patch").set(std::string("Coupling/Stopping/Tolerance=") + tolerance).run();
    EXPECT_EQ(outcome.run.summary.coupling->sweeps, expected) << tolerance;
    EXPECT_TRUE(outcome.run.summary.coupling->converged);
  }
}

TEST(PatchDeck, IsExactOnUnstructuredMeshesOfGmsh)
{
  const TemporaryFolder folder;
  for (const double degrees : {0.0, 30.0}) {
    const double c = std::cos(degrees * M_PI / 180.0), s = std::sin(degrees * M_PI / 180.0);
    std::string script;
    const double corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, -1}, {1, -1}};
    for (int i = 0; i < 6; ++i)
      script += fmt::format("Point({}) = {{{}, {}, 0, 0.3}};\n", i + 1, c * corners[i][0] - s * corners[i][1],
                            s * corners[i][0] + c * corners[i][1]);
    writeFile(folder.file("blocks.geo"), script + R"(
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {1, 5}; Line(6) = {5, 6}; Line(7) = {6, 2};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6, 7, -1};
Plane Surface(1) = {1}; Plane Surface(2) = {2};
Physical Curve("contact") = {1}; Physical Curve("top") = {3}; Physical Curve("left") = {4, 5};
Physical Curve("bottom") = {6};
Physical Surface("upper") = {1}; Physical Surface("lower") = {2};
)");
    for (const char* order : {"1", "2"}) {
      Scene scene("patch");
      setBoth(scene, "Mesh/Type=Gmsh");
      setBoth(scene, "Mesh/File=" + folder.file("blocks.geo"));
      scene.set("Bodies/upper/Mesh/Regions={upper}").set("Bodies/lower/Mesh/Regions={lower}");
      scene.set("Interfaces/contact/Dirichlet Side=contact").set("Interfaces/contact/Neumann Side=contact");
      scene.set(std::string("Discretization/Order=") + order).set("Coupling/Initial Traction=Balanced");
      const auto outcome = scene.run();
      EXPECT_GT(outcome.run.model.bodies[0].mesh.numCells(), 20);
      expectExactFields(outcome.run, planeStrain(), degrees);
    }
  }
}

/// A brick on three rollers under pressure, turned about z.
TEST(PatchDeck, IsExactForASolid)
{
  for (const char* order : {"1", "2"})
    for (const double degrees : {0.0, 30.0}) {
      Scene brick = Scene::fromText(R"xml(<ParameterList name="brick"><ParameterList name="Bodies">
        <ParameterList name="brick">
          <ParameterList name="Mesh">
            <Parameter name="Type" type="string" value="Box"/>
            <Parameter name="Lower" type="Array(double)" value="{0, 0, 0}"/>
            <Parameter name="Upper" type="Array(double)" value="{1, 2, 1}"/>
            <Parameter name="Cells" type="Array(int)" value="{2, 3, 2}"/>
          </ParameterList>
          <ParameterList name="Material">
            <Parameter name="Young Modulus" type="double" value="4"/>
            <Parameter name="Poisson Ratio" type="double" value="0.25"/>
            <Parameter name="Hypothesis" type="string" value="Three Dimensional"/>
          </ParameterList>
        </ParameterList></ParameterList></ParameterList>)xml");
      for (const char* side : {"left", "front", "bottom"})
        brick.set(fmt::format("Bodies/brick/Supports/{0}/Type=Roller", side))
            .set(fmt::format("Bodies/brick/Supports/{0}/Side={0}", side));
      brick.set("Bodies/brick/Loads/press/Type=Pressure").set("Bodies/brick/Loads/press/Side=right");
      brick.set("Bodies/brick/Loads/press/Value=2").set(fmt::format("Discretization/Order={}", order)).rotate(degrees);
      const auto outcome = brick.run();
      const auto& body = outcome.run.model.bodies[0];
      const double c = std::cos(degrees * M_PI / 180.0), s = std::sin(degrees * M_PI / 180.0);
      Vector exact;
      for (int i = 0; i < body.nodes.numNodes(); ++i) {
        const auto p = body.nodes.point(i);
        const double x = c * p[0] + s * p[1], y = c * p[1] - s * p[0];
        const double ux = -0.5 * x, uy = 0.125 * y;
        exact.insert(exact.end(), {c * ux - s * uy, s * ux + c * uy, 0.125 * p[2]});
      }
      EXPECT_LT(relativeDifference(displacement(outcome.run, 0), exact), 1e-12);
      EXPECT_NEAR(outcome.run.summary.energy, 2.0, 1e-12);
      for (const auto& stress : cellStress(body, displacement(outcome.run, 0))) {
        const std::array<double, 6> expected{-2 * c * c, -2 * s * s, 0.0, -2 * s * c, 0.0, 0.0};
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_NEAR(stress[k], expected[k], 1e-11);
      }
    }
}
