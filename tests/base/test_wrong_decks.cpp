#include <ostream>

#include <gtest/gtest.h>

#include "base/sample_spec.hpp"

using namespace ndframe;

namespace
{

/// One wrong deck: the full deck with one text replaced, and what must be said of it.
struct WrongDeck
{
  const char* what;
  std::string replaced;
  std::string replacement;
  std::string message;
};

/// GoogleTest names the case by this.
void PrintTo(const WrongDeck& wrong, std::ostream* stream)
{
  *stream << wrong.what;
}

std::string fullDeckWith(const std::string& replaced, const std::string& replacement)
{
  std::string deck = test::fullDeck();
  const auto at = deck.find(replaced);
  EXPECT_NE(at, std::string::npos) << "the full deck does not hold " << replaced;
  return deck.replace(at, replaced.size(), replacement);
}

class WrongDecks : public testing::TestWithParam<WrongDeck>
{};

std::string caseName(const testing::TestParamInfo<WrongDeck>& info)
{
  return info.param.what;
}

} // namespace

TEST_P(WrongDecks, AreAnsweredWithPlaceReasonAndRemedy)
{
  const auto& wrong = GetParam();
  EXPECT_EQ(test::complaint(fullDeckWith(wrong.replaced, wrong.replacement)), wrong.message);
}

INSTANTIATE_TEST_SUITE_P(
    Xml, WrongDecks,
    testing::Values(
        WrongDeck{"Doctype", "<ParameterList name=\"full\">", "<!DOCTYPE deck>\n<ParameterList name=\"full\">",
                  "deck.xml:3: DOCTYPE and entity declarations (\"<!...\") are not allowed in a deck; remove them."},
        WrongDeck{
            "EntityBomb", "<ParameterList name=\"full\">",
            "<!DOCTYPE lolz [ <!ENTITY lol \"lol\"> <!ENTITY lol2 \"&lol;&lol;\"> ]>\n<ParameterList name=\"&lol2;\">",
            "deck.xml:3: DOCTYPE and entity declarations (\"<!...\") are not allowed in a deck; remove them."},
        WrongDeck{"UnclosedTag", "  <ParameterList name=\"Library\">", "  <ParameterList name=\"Library\"",
                  "deck.xml:40: is not valid XML: a tag is malformed or does not end."},
        WrongDeck{
            "MismatchedTag", "</ParameterList>\n    <ParameterList name=\"lower\">",
            "</ParameterLists>\n    <ParameterList name=\"lower\">",
            "deck.xml:10: is not valid XML: a tag is closed by another tag's end, or not closed before its list ends."},
        WrongDeck{"UnquotedAttribute", "name=\"Gap\"", "name=Gap",
                  "deck.xml:8: is not valid XML: an attribute is malformed or given twice; write name=\"value\" once."},
        WrongDeck{"UnclosedComment", "<Parameter> -->", "<Parameter> ",
                  "deck.xml:2: is not valid XML: a comment does not end with \"-->\"."},
        WrongDeck{"MissingType", "name=\"Gap\" type=\"string\"", "name=\"Gap\"",
                  "deck.xml:8: <Parameter name=\"Gap\"> has no attribute \"type\" (bool, int, double, string, "
                  "Array(int), Array(double) or Array(string))."},
        WrongDeck{"MissingValue", "name=\"Gap\" type=\"string\" value=\"0.5*x^2\"", "name=\"Gap\" type=\"string\"",
                  "deck.xml:8: <Parameter name=\"Gap\"> has no attribute \"value\"."},
        WrongDeck{"MissingName", "<ParameterList name=\"upper\">", "<ParameterList>",
                  "deck.xml:10: Bodies: <ParameterList> has no attribute \"name\"."},
        WrongDeck{"EmptyName", "name=\"upper\"", "name=\"\"",
                  "deck.xml:10: Bodies: the name \"\" is not valid: a name is not empty, holds no \"/\", neither "
                  "begins nor ends with a space."},
        WrongDeck{"SlashInName", "name=\"upper\"", "name=\"up/per\"",
                  "deck.xml:10: Bodies: the name \"up/per\" is not valid: a name is not empty, holds no \"/\", neither "
                  "begins nor ends with a space."},
        WrongDeck{"SpaceInParameter", "name=\"Gap\"", "name=\" Gap\"",
                  "deck.xml:8: the name \" Gap\" is not valid: a name is not empty, neither begins nor ends with a "
                  "space."},
        WrongDeck{"UnknownAttribute", "name=\"Gap\" type", "name=\"Gap\" typ",
                  "deck.xml:8: <Parameter> takes no attribute \"typ\"; it takes name, type, value.\n"
                  "deck.xml:8: <Parameter name=\"Gap\"> has no attribute \"type\" (bool, int, double, string, "
                  "Array(int), Array(double) or Array(string))."},
        WrongDeck{"DoubledAttribute", "name=\"Gap\" ", "name=\"Gap\" name=\"Gap\" ",
                  "deck.xml:8: is not valid XML: an attribute is malformed or given twice; write name=\"value\" once."},
        WrongDeck{"UnknownElement", "<Parameter name=\"Gap\"", "<Paramter name=\"Gap\"",
                  "deck.xml:8: <Paramter> is unknown; did you mean <Parameter>?"},
        WrongDeck{"ForeignElement", "<Parameter name=\"Gap\"", "<mesh name=\"Gap\"",
                  "deck.xml:8: <mesh> is unknown; a list holds <ParameterList> and <Parameter>."},
        WrongDeck{"StrayText", "<ParameterList name=\"Bodies\">", "hello <ParameterList name=\"Bodies\">",
                  "deck.xml:9: \"hello\" is between the tags; a deck has its values in attributes."},
        WrongDeck{"TextInParameter", "value=\"0.5*x^2\"/>", "value=\"0.5*x^2\">1</Parameter>",
                  "deck.xml:8: a <Parameter> has no content; its value is in the attribute \"value\"."},
        WrongDeck{"TwoRoots", "  <ParameterList name=\"Bodies\">",
                  "</ParameterList>\n<ParameterList name=\"more\">\n  <ParameterList name=\"Bodies\">",
                  "deck.xml:10: the deck continues after its outer </ParameterList>; only comments may follow it."},
        WrongDeck{"DoubledKey", "name=\"Pattern\"", "name=\"Title\"",
                  "deck.xml:5: \"Title\" is given twice, first in line 4; remove one."},
        WrongDeck{"DoubledList", "name=\"lower\"", "name=\"upper\"",
                  "deck.xml:18: Bodies: \"upper\" is given twice, first in line 10; remove one."},
        WrongDeck{"ListNamedLikeAKey", "name=\"Output\"", "name=\"Gap\"",
                  "deck.xml:37: \"Gap\" is given twice, first in line 8; remove one."},
        WrongDeck{"ControlCharacter", "Punch", "Punch&#7;",
                  "deck.xml:4: the attribute \"value\" holds a control character or is not UTF-8."}),
    caseName);

INSTANTIATE_TEST_SUITE_P(
    Names, WrongDecks,
    testing::Values(
        WrongDeck{"MisspeltKey", "name=\"Pattern\"", "name=\"Patern\"",
                  "deck.xml:5: \"Patern\" is not a parameter here; did you mean \"Pattern\"?"},
        WrongDeck{"MisspeltList", "name=\"Stopping\"", "name=\"Stoping\"",
                  "deck.xml:33: Coupling: \"Stoping\" is not a list here; did you mean \"Stopping\"?"},
        WrongDeck{"KeyOfAnotherList", "name=\"Pattern\" type=\"string\" value=\"Crossed\"",
                  "name=\"Tolerance\" type=\"double\" value=\"1\"",
                  "deck.xml:5: \"Tolerance\" is not a parameter here; it belongs to Coupling/Stopping."},
        WrongDeck{"KeyOfTheOuterList", "name=\"Tolerance\" type=\"double\" value=\"0.1\"",
                  "name=\"Grading\" type=\"double\" value=\"1\"",
                  "deck.xml:34: Coupling/Stopping: \"Grading\" is not a parameter here; it belongs to the outer list."},
        WrongDeck{"ListOfAnotherList", "name=\"Output\"", "name=\"Relaxation\"",
                  "deck.xml:37: \"Relaxation\" is not a list here; it belongs to Coupling."},
        WrongDeck{
            "KeyOfAnotherComponent", "name=\"Type\" type=\"string\" value=\"Aitken\"/>",
            "name=\"Type\" type=\"string\" value=\"Aitken\"/>\n<Parameter name=\"Theta\" type=\"double\" value=\"1\"/>",
            "deck.xml:29: Coupling/Relaxation: \"Theta\" is not a parameter of Aitken (it belongs to Constant)."},
        WrongDeck{"ListOfAnotherComponent", "value=\"Aitken\"", "value=\"Constant\"",
                  "deck.xml:29: Coupling/Relaxation: \"History\" is not a list of Constant (it belongs to Aitken)."},
        WrongDeck{"KeyThatIsLikeNoOther", "name=\"Tolerance\"", "name=\"Colour of the screen\"",
                  "deck.xml:34: Coupling/Stopping: \"Colour of the screen\" is not a parameter here; valid names: "
                  "Tolerance, Maximum Sweeps."},
        WrongDeck{"KeyWhereOnlyListsMayStand", "<ParameterList name=\"upper\">",
                  "<Parameter name=\"Colour\" type=\"int\" value=\"1\"/><ParameterList name=\"upper\">",
                  "deck.xml:10: Bodies: \"Colour\" is not a parameter here; it takes lists that you name."},
        WrongDeck{"ListWhereNoneMayStand", "<Parameter name=\"Exodus\" type=\"bool\" value=\"false\"/>",
                  "<ParameterList name=\"Colours\"/>",
                  "deck.xml:38: Output: \"Colours\" is not a list here; it takes no lists."},
        WrongDeck{"ListWrittenAsKey",
                  "<ParameterList name=\"Output\">\n    <Parameter name=\"Exodus\" type=\"bool\" value=\"false\"/>\n  "
                  "</ParameterList>",
                  "<Parameter name=\"Output\" type=\"string\" value=\"all\"/>",
                  "deck.xml:37: \"Output\" is a list here: write <ParameterList name=\"Output\" .../>."},
        WrongDeck{"KeyWrittenAsList", "<Parameter name=\"Gap\" type=\"string\" value=\"0.5*x^2\"/>",
                  "<ParameterList name=\"Gap\"/>",
                  "deck.xml:8: \"Gap\" is a parameter here: write <Parameter name=\"Gap\" .../>."},
        WrongDeck{"UnknownComponent", "value=\"Isotropic\"", "value=\"Isotrop\"",
                  "deck.xml:14: Bodies/upper/Material: Type = \"Isotrop\" is not one of Isotropic | Orthotropic; did "
                  "you mean \"Isotropic\"?"},
        WrongDeck{"ComponentLikeNoOther", "value=\"Isotropic\"", "value=\"Honey\"",
                  "deck.xml:14: Bodies/upper/Material: Type = \"Honey\" is not one of Isotropic | Orthotropic."},
        WrongDeck{"KeyOfNoComponentAtAll", "value=\"Isotropic\"/>",
                  "value=\"Honey\"/><Parameter name=\"Stickiness\" type=\"int\" value=\"1\"/>",
                  "deck.xml:14: Bodies/upper/Material: \"Stickiness\" is not a parameter here; valid names: Type.\n"
                  "deck.xml:14: Bodies/upper/Material: Type = \"Honey\" is not one of Isotropic | Orthotropic."},
        WrongDeck{"LibraryKey", "name=\"level\"", "name=\"levle\"",
                  "deck.xml:40: Library: the library has no parameter \"levle\"."}),
    caseName);

INSTANTIATE_TEST_SUITE_P(
    Missing, WrongDecks,
    testing::Values(
        WrongDeck{"MisspeltRequiredList", "name=\"Bodies\"", "name=\"Bodys\"",
                  "deck.xml:9: \"Bodys\" is not a list here; did you mean \"Bodies\"?"},
        WrongDeck{"MisspeltRequiredKey", "name=\"Young Modulus\"", "name=\"Young's Modulus\"",
                  "deck.xml:15: Bodies/upper/Material: \"Young's Modulus\" is not a parameter here; did you mean "
                  "\"Young Modulus\"?"},
        WrongDeck{
            "ForeignListForARequiredOne", "name=\"Bodies\"", "name=\"Solids in contact\"",
            "deck.xml:3: the list \"Bodies\" is missing.\n"
            "deck.xml:9: \"Solids in contact\" is not a list here; valid names: Bodies, Coupling, Output, Library."},
        WrongDeck{"MissingListOfABody", "<ParameterList name=\"upper\">",
                  "<ParameterList name=\"third\"/><ParameterList name=\"upper\">",
                  "deck.xml:10: Bodies/third: the list \"Material\" is missing."},
        WrongDeck{"MissingType", "<Parameter name=\"Type\" type=\"string\" value=\"Isotropic\"/>", "",
                  "deck.xml:13: Bodies/upper/Material: Type is missing (string, Isotropic | Orthotropic)."},
        WrongDeck{"MissingKey", "<Parameter name=\"Young Modulus\" type=\"double\" value=\"2.1e11\"/>", "",
                  "deck.xml:13: Bodies/upper/Material: Young Modulus is missing (double, > 0)."},
        WrongDeck{
            "MissingArray",
            "<Parameter name=\"Young Moduli\" type=\"Array(double)\" value=\"{0.1, 1e300, 3.3333333333333335}\"/>", "",
            "deck.xml:20: Bodies/lower/Material: Young Moduli is missing (Array(double), > 0)."}),
    caseName);

INSTANTIATE_TEST_SUITE_P(
    Values, WrongDecks,
    testing::Values(
        WrongDeck{"UnknownType", "type=\"double\" value=\"0.1\"", "type=\"float\" value=\"0.1\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance has the unknown type \"float\"; write double."},
        WrongDeck{"WrongType", "type=\"double\" value=\"0.1\"", "type=\"string\" value=\"0.1\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance is of type string; it must be double."},
        WrongDeck{"DoubleForInt", "type=\"int\" value=\"3\"", "type=\"double\" value=\"3\"",
                  "deck.xml:30: Coupling/Relaxation/History: Depth is of type double; it must be int."},
        WrongDeck{"ScalarForArray", "type=\"Array(int)\" value=\"{ 8,8 }\"", "type=\"int\" value=\"8\"",
                  "deck.xml:11: Bodies/upper: Cells is of type int; it must be Array(int)."},
        WrongDeck{"BoolForExpression", "type=\"string\" value=\"0.5*x^2\"", "type=\"bool\" value=\"true\"",
                  "deck.xml:8: Gap is of type bool; it must be double or string (an expression in x, y, z)."},
        WrongDeck{"NotANumber", "value=\"0.1\"", "value=\"0,1\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance = \"0,1\" is not a number."},
        WrongDeck{"NumberWithUnit", "value=\"2.1e11\"", "value=\"2.1e11 Pa\"",
                  "deck.xml:15: Bodies/upper/Material: Young Modulus = \"2.1e11 Pa\" is not a number."},
        WrongDeck{"EmptyNumber", "value=\"0.1\"", "value=\"\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance = \"\" is not a number."},
        WrongDeck{"NaN", "value=\"0.1\"", "value=\"NaN\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance = \"NaN\" is not finite."},
        WrongDeck{"Infinity", "value=\"0.1\"", "value=\"-inf\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance = \"-inf\" is not finite."},
        WrongDeck{"TooLarge", "value=\"0.1\"", "value=\"1e400\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance = \"1e400\" is too large or too small for a double."},
        WrongDeck{"IntTooLarge", "type=\"int\" value=\"3\"", "type=\"int\" value=\"3000000000\"",
                  "deck.xml:30: Coupling/Relaxation/History: Depth = \"3000000000\" does not fit in an int."},
        WrongDeck{"FractionForInt", "type=\"int\" value=\"3\"", "type=\"int\" value=\"3.5\"",
                  "deck.xml:30: Coupling/Relaxation/History: Depth = \"3.5\" is not an int."},
        WrongDeck{"StatedIntWithFraction", "name=\"Thickness\" type=\"int\" value=\"2\"",
                  "name=\"Thickness\" type=\"int\" value=\"2.5\"",
                  "deck.xml:12: Bodies/upper: Thickness = \"2.5\" is not an int."},
        WrongDeck{"NotABool", "type=\"bool\" value=\"false\"", "type=\"bool\" value=\"no\"",
                  "deck.xml:38: Output: Exodus = \"no\" is not a bool (true or false)."},
        WrongDeck{"OutOfAnInterval", "type=\"int\" value=\"3\"", "type=\"int\" value=\"7\"",
                  "deck.xml:30: Coupling/Relaxation/History: Depth = 7 is outside [1, 5]."},
        WrongDeck{"BelowALimit", "value=\"0.1\"", "value=\"0\"",
                  "deck.xml:34: Coupling/Stopping: Tolerance = 0 is not valid: it must be > 0."},
        WrongDeck{"ArrayElementBelowALimit", "value=\"{1, 2}\"", "value=\"{1, -2}\"",
                  "deck.xml:7: Grading = {1, -2} is not valid: it must be > 0."},
        WrongDeck{
            "NotAChoice", "value=\"Crossed\"", "value=\"crosed\"",
            "deck.xml:5: Pattern = \"crosed\" is not one of Right | Alternating | Crossed; did you mean \"Crossed\"?"},
        WrongDeck{"ArrayElementNotAChoice", "value=\"{stress, gap}\"", "value=\"{stress, strain}\"",
                  "deck.xml:6: Fields = {stress, strain} is not one of stress | gap."},
        WrongDeck{"NotAnArray", "value=\"{ 8,8 }\"", "value=\"8, 8\"",
                  "deck.xml:11: Bodies/upper: Cells = \"8, 8\" is not an array such as {1, 2, 3}."},
        WrongDeck{"WrongArrayElement", "value=\"{ 8,8 }\"", "value=\"{8, eight}\"",
                  "deck.xml:11: Bodies/upper: Cells = \"{8, eight}\" is wrong in element 2: eight is not an int."},
        WrongDeck{"EmptyArrayElement", "value=\"{ 8,8 }\"", "value=\"{8, }\"",
                  "deck.xml:11: Bodies/upper: Cells = \"{8, }\" is not a flat array: its element 2 is \"\"."},
        WrongDeck{
            "NestedArray", "value=\"{ 8,8 }\"", "value=\"{{8, 8}, {8, 8}}\"",
            "deck.xml:11: Bodies/upper: Cells = \"{{8, 8}, {8, 8}}\" is not a flat array: its element 1 is \"{8\"."},
        WrongDeck{"NonFiniteArrayElement", "value=\"{0.1, 1e300, 3.3333333333333335}\"", "value=\"{0.1, inf}\"",
                  "deck.xml:22: Bodies/lower/Material: Young Moduli = \"{0.1, inf}\" is wrong in element 2: inf is not "
                  "finite."},
        WrongDeck{"ExpressionWithUnknownName", "value=\"0.5*x^2\"", "value=\"0.5*r^2\"",
                  "deck.xml:8: Gap = \"0.5*r^2\" is not an expression in x, y, z: \"r\" at character 5 is unknown; an "
                  "expression may use x, y, z, pi and functions such as sin, sqrt, exp, abs, min, max."},
        WrongDeck{
            "ExpressionThatEnds", "value=\"0.5*x^2\"", "value=\"0.5*\"",
            "deck.xml:8: Gap = \"0.5*\" is not an expression in x, y, z: Unexpected end of expression at position 5."},
        WrongDeck{"ExpressionStatedAsNumber", "type=\"string\" value=\"0.5*x^2\"", "type=\"double\" value=\"0.5*x^2\"",
                  "deck.xml:8: Gap = \"0.5*x^2\" is not a number."},
        WrongDeck{"LibraryType", "name=\"level\" type=\"int\"", "name=\"level\" type=\"long\"",
                  "deck.xml:41: Library: level has the unknown type \"long\"; write bool, int, double, string, "
                  "Array(int), Array(double) or Array(string)."}),
    caseName);

TEST(WrongDeck, HasAllItsMistakesReportedInTheOrderOfTheLines)
{
  EXPECT_EQ(test::complaint(R"xml(<ParameterList name="many">
  <Parameter name="Patern" type="string" value="Right"/>
  <ParameterList name="Coupling">
    <ParameterList name="Relaxation">
      <Parameter name="Theta" type="double" value="2.5"/>
    </ParameterList>
    <ParameterList name="Stopping">
      <Parameter name="Tolerance" type="double" value="nan"/>
    </ParameterList>
  </ParameterList>
  <Parameter name="Gap" type="string" value="sin(r)"/>
</ParameterList>)xml"),
            "deck.xml:1: the list \"Bodies\" is missing.\n"
            "deck.xml:2: \"Patern\" is not a parameter here; did you mean \"Pattern\"?\n"
            "deck.xml:5: Coupling/Relaxation: Theta = 2.5 is outside (0, 2).\n"
            "deck.xml:8: Coupling/Stopping: Tolerance = \"nan\" is not finite.\n"
            "deck.xml:11: Gap = \"sin(r)\" is not an expression in x, y, z: \"r\" at character 5 is unknown; an "
            "expression may use x, y, z, pi and functions such as sin, sqrt, exp, abs, min, max.");
}

TEST(WrongDeck, CutAnywhereIsRefused)
{
  const std::string deck = test::fullDeck();
  for (std::size_t length = 0; length + 2 < deck.size(); ++length)
    EXPECT_NE(test::complaint(deck.substr(0, length)), "") << "cut after " << length << " bytes";
  EXPECT_EQ(test::complaint(deck.substr(0, deck.find("  <ParameterList name=\"Output\">"))),
            "deck.xml:3: is not valid XML: a tag is not closed before the file ends.");
}

TEST(WrongDeck, NestedWithoutEndIsRefused)
{
  std::string deck;
  for (int i = 0; i < 10000; ++i)
    deck += "<ParameterList name=\"a\">";
  EXPECT_EQ(test::complaint(deck), "deck.xml:1: is not valid XML: the lists are nested too deeply.");
}

TEST(WrongDeck, WithoutAListIsRefused)
{
  EXPECT_EQ(test::complaint("<!-- nothing -->"), "deck.xml:1: holds no <ParameterList>.");
  EXPECT_EQ(test::complaint("<html/>"), "deck.xml:1: a deck is one <ParameterList>, not <html>.");
  EXPECT_EQ(test::complaint("punch"), "deck.xml:1: is not valid XML: there is text outside the tags.");
}
