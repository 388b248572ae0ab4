// Scenes that are allowed but probably a mistake: each is warned of, and those that look like them are not.

#include <gmock/gmock.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace
{

std::vector<WarningSummary> warningsOf(const Scene& scene)
{
  return scene.run().run.summary.warnings;
}

auto warning(const std::string& kind, const std::string& message)
{
  return AllOf(testing::Field(&WarningSummary::kind, kind),
               testing::Field(&WarningSummary::message, HasSubstr(message)));
}

/// Steel on steel in N and mm: strains of some 1e-5.
Scene steelPunch()
{
  return Scene("punch")
      .set("Strain Limit=0.05")
      .set("Bodies/punch/Material/Young Modulus=210000")
      .set("Bodies/foundation/Material/Young Modulus=210000")
      .set("Coupling/Stopping/Tolerance=1e-3");
}

const std::string box = R"xml(
<ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
  <Parameter name="Lower" type="Array(double)" value="{LOWER}"/>
  <Parameter name="Upper" type="Array(double)" value="{UPPER}"/>
  <Parameter name="Cells" type="Array(int)" value="{4, 4}"/>
</ParameterList>
<ParameterList name="Material"><Parameter name="Young Modulus" type="double" value="1000"/>
  <Parameter name="Poisson Ratio" type="double" value="0.3"/></ParameterList>
<ParameterList name="Supports"><ParameterList name="ground"><Parameter name="Type" type="string" value="Clamp"/>
  <Parameter name="Side" type="string" value="SIDE"/></ParameterList></ParameterList>
<ParameterList name="Loads"><ParameterList name="press"><Parameter name="Type" type="string" value="Pressure"/>
  <Parameter name="Side" type="string" value="right"/><Parameter name="Value" type="double" value="PRESSURE"/>
</ParameterList></ParameterList>)xml";

std::string body(const std::string& name, const std::string& lower, const std::string& upper, const std::string& held,
                 const std::string& pressure)
{
  std::string text = replacedOnce(replacedOnce(box, "LOWER", lower), "UPPER", upper);
  text = replacedOnce(replacedOnce(text, "SIDE", held), "PRESSURE", pressure);
  return "<ParameterList name=\"" + name + "\">" + text + "</ParameterList>";
}

/// Two boxes without interface, the second with its left side at x.
Scene twoBoxes(const std::string& x, const std::string& upper, const std::string& pressure)
{
  return Scene::fromText("<ParameterList name=\"two\"><ParameterList name=\"Bodies\">" +
                         body("one", "0, 0", "1, 1", "left", pressure) +
                         body("two", x + ", 0.3", upper + ", 1.3", "top", "0.01") + "</ParameterList></ParameterList>");
}

} // namespace

TEST(Warnings, SteelOnSteelHasNone)
{
  EXPECT_THAT(warningsOf(steelPunch()), IsEmpty());
}

TEST(Warnings, OfStrainsTheTheoryDoesNotHoldFor)
{
  const auto large = warningsOf(steelPunch().set("Bodies/punch/Loads/press/Value=30000"));
  EXPECT_THAT(large, Contains(warning("strain", "the theory assumes small strains")));
  EXPECT_THAT(large, Contains(warning("strain", "Bodies/punch: strains reach 0.3")));
  EXPECT_THAT(warningsOf(steelPunch().set("Bodies/punch/Loads/press/Value=30000").set("Strain Limit=0.5")), IsEmpty());
}

TEST(Warnings, OfStrainsAtACornerOnlyAreNone)
{
  // 6 % at the corner of the punch, 2.5 % elsewhere: the singular strain belongs to the mesh.
  const Scene scene = steelPunch()
                          .set("Bodies/punch/Loads/press/Value=4500")
                          .set("Bodies/punch/Mesh/Cells={120, 120}")
                          .set("Bodies/foundation/Mesh/Cells={240, 120}");
  const Outcome outcome = scene.run();
  EXPECT_GT(outcome.run.summary.bodies[0].strain.value, 0.05);
  EXPECT_THAT(outcome.run.summary.warnings, IsEmpty());
}

TEST(Warnings, OfUnitsThatDoNotFit)
{
  // The modulus in Pa, loads in MPa; and the reverse.
  const auto tiny = warningsOf(steelPunch()
                                   .set("Bodies/punch/Material/Young Modulus=210e9")
                                   .set("Bodies/foundation/Material/Young Modulus=210e9"));
  EXPECT_THAT(tiny, ElementsAre(warning("strain", "such loads hardly deform bodies with such moduli")));
  EXPECT_THAT(warningsOf(steelPunch().set("Bodies/punch/Loads/press/Value=1e6")), Contains(warning("strain", "units")));
}

TEST(Warnings, OfModuliInDifferentUnits)
{
  const auto scene = [](const std::string& modulus) {
    return steelPunch().set("Bodies/foundation/Material/Young Modulus=" + modulus);
  };
  EXPECT_THAT(
      warningsOf(scene("210001e6")),
      Contains(warning("different moduli", "Bodies/punch/Material: it is 1e+06 times as soft as "
                                           "Bodies/foundation/Material: are all moduli set, and in one unit?")));
  EXPECT_THAT(warningsOf(scene("210000e5")), IsEmpty()); // steel on rubber
}

TEST(Warnings, OfBodiesThatAreMovedAndDoNotMeet)
{
  const auto moved = [](const std::string& way) {
    return steelPunch()
        .set("Bodies/punch/Loads/press/Value=0")
        .set("Bodies/punch/Supports/moved/Type=Displacement")
        .set("Bodies/punch/Supports/moved/Side=top")
        .set("Bodies/punch/Supports/moved/Y=" + way)
        .set("Interfaces/contact/Gap=1e-3");
  };
  EXPECT_THAT(
      warningsOf(moved("-4e-4")),
      ElementsAre(warning("strain", "nothing touches, and no body is strained: the smallest remaining opening is "
                                    "0.0006, in \"contact\" at ")));
  EXPECT_THAT(warningsOf(moved("-1.4e-3")), IsEmpty());
}

TEST(Warnings, OfStrainsInRigidMotionsAndEmptyScenesAreNone)
{
  EXPECT_THAT(
      warningsOf(
          Scene("patch").set("Strain Limit=2").set("Bodies/upper/Loads/press/Value=0").set("Coupling/Type=Monolithic")),
      ElementsAre(warning("not unique", "the displacement is not unique: upper along +y. ")));
}

/// The punch pressed against its roller, which leaves open how far it is from the foundation.
TEST(Warnings, OfBodiesThatNoLoadPressesOnWhatHoldsThem)
{
  const auto scene = [] { return steelPunch().set("Bodies/punch/Loads/press/Side=right"); };
  EXPECT_THAT(warningsOf(scene()), ElementsAre(warning("not unique", "not unique: punch along +y. Nothing but")));
  EXPECT_THAT(warningsOf(scene().reverseBodies()), ElementsAre(warning("not unique", "punch along +y")));
  EXPECT_THAT(warningsOf(scene().changeUnits(1e3, 1e-6)), Contains(warning("not unique", "punch along +y")));
  EXPECT_THAT(warningsOf(scene().rotate(30.0)), ElementsAre(warning("not unique", "punch along (-0.5, 0.866)")));
  EXPECT_THAT(complaintOf(scene().set("Strict Input=true")), HasSubstr("the displacement is not unique: punch along"));
}

TEST(Warnings, OfBodiesThatMoveUntilTheyTouchAreNone)
{
  EXPECT_THAT(warningsOf(steelPunch().set("Interfaces/contact/Gap=1e-5")), IsEmpty());
}

TEST(Warnings, OfDifferentHypotheses)
{
  EXPECT_THAT(warningsOf(steelPunch().set("Bodies/foundation/Material/Hypothesis=Plane Stress")),
              ElementsAre(warning("different hypotheses", "Plane Stress here, Plane Strain for body \"punch\"")));
}

TEST(Warnings, OfLinearElementsThatLock)
{
  const auto scene = [] { return steelPunch().set("Bodies/punch/Material/Poisson Ratio=0.46"); };
  EXPECT_THAT(warningsOf(scene().set("Discretization/Order=1")),
              ElementsAre(warning("locking", "Bodies/punch/Material: elements of order 1 lock at a Poisson ratio of "
                                             "0.46")));
  EXPECT_THAT(warningsOf(scene()), IsEmpty()) << "order 2 does not lock";
  EXPECT_THAT(warningsOf(scene()
                             .set("Discretization/Order=1")
                             .set("Bodies/punch/Material/Hypothesis=Plane Stress")
                             .set("Bodies/foundation/Material/Hypothesis=Plane Stress")),
              IsEmpty())
      << "plane stress does not lock";
}

TEST(Warnings, OfLoadsThatGoIntoASupport)
{
  EXPECT_THAT(warningsOf(steelPunch()
                             .set("Bodies/foundation/Loads/lost/Type=Pressure")
                             .set("Bodies/foundation/Loads/lost/Side=left")
                             .set("Bodies/foundation/Loads/lost/Value=1")),
              ElementsAre(warning("load on a support", "15 of the 15 facets of this load are held along it by the "
                                                       "support \"symmetry\" (roller at left)")));
  EXPECT_THAT(warningsOf(steelPunch()
                             .set("Bodies/foundation/Loads/shear/Type=Traction")
                             .set("Bodies/foundation/Loads/shear/Side=left")
                             .set("Bodies/foundation/Loads/shear/Y=-1")),
              IsEmpty())
      << "a roller lets its side slide";
}

TEST(Warnings, OfBodiesThatTouchWithoutAnInterface)
{
  EXPECT_THAT(warningsOf(twoBoxes("1", "2", "0.1")),
              ElementsAre(warning("touching bodies", "the boundaries of \"one\" and \"two\" coincide at (1, ")));
  EXPECT_THAT(warningsOf(twoBoxes("0.9", "2", "0.1")),
              ElementsAre(warning("touching bodies", "\"one\" and \"two\" overlap in the mesh")));
  EXPECT_THAT(warningsOf(twoBoxes("1.1", "2", "0.1")), IsEmpty()) << "apart";
  EXPECT_THAT(warningsOf(twoBoxes("1.001", "2", "0.1")), IsEmpty()) << "apart, and hardly moved";
}

TEST(Warnings, OfBodiesThatTheLoadBringsIntoEachOther)
{
  EXPECT_THAT(warningsOf(twoBoxes("1.001", "2", "-10")),
              ElementsAre(warning("overlapping bodies", "the displacements make \"one\" and \"two\" overlap")));
  EXPECT_THAT(warningsOf(twoBoxes("1.02", "2", "-10")), IsEmpty()) << "not as far";
}

TEST(Warnings, OfContactThatReachesTheEndOfASideThatGoesOn)
{
  // Only the left half of the punch is named, although the whole of it stands on the foundation.
  const auto scene = [](const std::string& at) {
    return steelPunch()
        .set("Bodies/punch/Mesh/Splits/half/Side=bottom")
        .set("Bodies/punch/Mesh/Splits/half/At={" + at + "}")
        .set("Bodies/punch/Mesh/Splits/half/Names={contact, rest}")
        .set("Bodies/foundation/Mesh/Splits/under the punch/At={" + at + "}")
        .set("Interfaces/contact/Dirichlet Side=contact");
  };
  const auto warnings = warningsOf(scene("0.4"));
  EXPECT_THAT(warnings,
              Contains(warning("contact at the end of a side",
                               "Interfaces/contact: there is contact pressure at the end of the sides, at (0.4, 0), "
                               "and the boundaries of both bodies continue close to each other")));
  EXPECT_THAT(warnings, Contains(warning("touching bodies", "coincide at (0.4")));
}

TEST(Warnings, OfAMeshOfUnconnectedParts)
{
  // Two squares of two triangles each, apart.
  TemporaryFolder folder;
  writeFile(folder.file("parts.msh"), "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                      "$PhysicalNames\n2\n1 1 \"base\"\n2 2 \"all\"\n$EndPhysicalNames\n"
                                      "$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                                      "5 2 0 0\n6 3 0 0\n7 3 1 0\n8 2 1 0\n$EndNodes\n"
                                      "$Elements\n6\n1 1 2 1 1 1 2\n2 1 2 1 2 5 6\n"
                                      "3 2 2 2 1 1 2 3\n4 2 2 2 1 1 3 4\n5 2 2 2 2 5 6 7\n6 2 2 2 2 5 7 8\n"
                                      "$EndElements\n");
  const Scene scene =
      Scene::fromText("<ParameterList name=\"parts\"><ParameterList name=\"Bodies\"><ParameterList name=\"plate\">"
                      "<ParameterList name=\"Mesh\"><Parameter name=\"Type\" type=\"string\" value=\"Gmsh\"/>"
                      "<Parameter name=\"File\" type=\"string\" value=\"" +
                      folder.file("parts.msh") +
                      "\"/></ParameterList><ParameterList name=\"Material\">"
                      "<Parameter name=\"Young Modulus\" type=\"double\" value=\"1000\"/>"
                      "<Parameter name=\"Poisson Ratio\" type=\"double\" value=\"0.3\"/></ParameterList>"
                      "<ParameterList name=\"Supports\"><ParameterList name=\"ground\">"
                      "<Parameter name=\"Type\" type=\"string\" value=\"Clamp\"/>"
                      "<Parameter name=\"Side\" type=\"string\" value=\"base\"/></ParameterList></ParameterList>"
                      "<ParameterList name=\"Loads\"><ParameterList name=\"weight\">"
                      "<Parameter name=\"Type\" type=\"string\" value=\"Body Force\"/>"
                      "<Parameter name=\"Y\" type=\"double\" value=\"-1\"/></ParameterList></ParameterList>"
                      "</ParameterList></ParameterList></ParameterList>");
  EXPECT_THAT(warningsOf(scene),
              ElementsAre(warning("unconnected parts", "Bodies/plate: its mesh has 2 parts that share no edge; one of "
                                                       "them is at (2.6")));
}

TEST(Warnings, OfContactOnOneOrTwoNodes)
{
  const auto scene = [] {
    return Scene("hertz")
        .set("Bodies/cylinder/Mesh/Cells={6, 4}")
        .set("Bodies/block/Mesh/Cells={6, 4}")
        .set("Bodies/cylinder/Loads/press/Value=1e-6");
  };
  EXPECT_THAT(warningsOf(scene()), Contains(warning("few contact nodes", "of 13 nodes: its width and pressure are")));
  EXPECT_THAT(warningsOf(Scene("hertz")), IsEmpty());
}

TEST(Warnings, StandOnTheErrorStreamAndInTheSummary)
{
  TemporaryFolder folder;
  const auto result = runProgram({"-q", shippedDeck("punch"), "--set", "Strain Limit=0.05"}, folder.file(""));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, HasSubstr("warning: Bodies/punch: strains reach 2.1"));
  EXPECT_THAT(contentsOf(folder.file("punch.summary.json")), HasSubstr("\"kind\": \"strain\""));
}

TEST(Warnings, AreErrorsUnderStrictInput)
{
  TemporaryFolder folder;
  const auto before = runProgram({shippedDeck("punch"), "--set", "Strict Input=true", "--set",
                                  "Bodies/foundation/Material/Hypothesis=Plane Stress"},
                                 folder.file(""));
  EXPECT_EQ(before.exitCode, 2);
  EXPECT_THAT(before.err, AllOf(HasSubstr("Plane Stress here, Plane Strain for body \"punch\""),
                                HasSubstr("1 error; nothing was computed.")));
  EXPECT_THAT(filesIn(folder.file("")), IsEmpty());
  const auto after =
      runProgram({shippedDeck("punch"), "--set", "Strict Input=true", "--set", "Strain Limit=0.05"}, folder.file(""));
  EXPECT_EQ(after.exitCode, 6);
  EXPECT_THAT(after.err, HasSubstr("Strict Input allows no warnings; the results are written."));
  EXPECT_THAT(filesIn(folder.file("")), Contains("punch.summary.json"));
  EXPECT_EQ(runProgram({"-q", shippedDeck("punch"), "--set", "Strict Input=true"}, folder.file("")).exitCode, 0);
}
