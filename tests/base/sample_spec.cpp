#include "base/sample_spec.hpp"

#include <Teuchos_ParameterList.hpp>

#include "ndframe/base/deck.hpp"

namespace ndframe::test
{

namespace
{

ListSpec materialSpec()
{
  ListSpec material;
  material.name = "Material";
  material.doc = "The elastic law.";
  material.isRequired = true;
  material.choices = Choices{{{"Isotropic",
                               "Two constants. Any dimension.",
                               {ParamSpec::required("Young Modulus", Kind::Double, above(0.0), "Stiffness."),
                                ParamSpec("Poisson Ratio", 0.3, inOpenRange(-1.0, 0.5), "Lateral contraction.")},
                               {}},
                              {"Orthotropic",
                               "Three axes.",
                               {ParamSpec::required("Young Moduli", Kind::Doubles, above(0.0), "One per axis.")},
                               {}}},
                             {}};
  return material;
}

ListSpec bodiesSpec()
{
  ListSpec body;
  body.name = "body";
  body.doc = "One elastic body.";
  body.params = {ParamSpec("Cells", std::vector<int>{4, 4}, atLeast(1.0), "Cells per direction."),
                 ParamSpec("Parts", std::vector<std::string>{"all"}, "Names of parts."),
                 ParamSpec::optional("Thickness", Kind::Double, above(0.0), "Only in plane problems.")};
  body.lists = {materialSpec()};
  ListSpec bodies;
  bodies.name = "Bodies";
  bodies.doc = "The bodies by name.";
  bodies.isRequired = true;
  bodies.each = std::make_shared<ListSpec>(body);
  return bodies;
}

ListSpec relaxationSpec()
{
  ListSpec history;
  history.name = "History";
  history.doc = "What Aitken remembers.";
  history.params = {ParamSpec("Depth", 1, inClosedRange(1, 5), "Sweeps back.")};
  ListSpec relaxation;
  relaxation.name = "Relaxation";
  relaxation.doc = "How the traction is relaxed.";
  relaxation.choices = Choices{
      {{"Constant", "A fixed factor.", {ParamSpec("Theta", 0.5, inOpenRange(0.0, 2.0), "The factor.")}, {}},
       {"Aitken", "From the last two residuals.", {ParamSpec("Initial Theta", 0.5, "First factor.")}, {history}}},
      "Constant"};
  return relaxation;
}

ListSpec couplingSpec()
{
  ListSpec stopping;
  stopping.name = "Stopping";
  stopping.doc = "When the sweeps end.";
  stopping.params = {ParamSpec("Tolerance", 1e-3, above(0.0), "On eps_tau."),
                     ParamSpec("Maximum Sweeps", 100, atLeast(1), "Give up after.")};
  ListSpec coupling;
  coupling.name = "Coupling";
  coupling.doc = "How the bodies are coupled.";
  coupling.lists = {relaxationSpec(), stopping};
  return coupling;
}

std::vector<std::string> onlyLevel(const Teuchos::ParameterList& list)
{
  std::vector<std::string> messages;
  for (auto entry = list.begin(); entry != list.end(); ++entry)
    if (list.name(entry) != "level")
      messages.push_back("the library has no parameter \"" + list.name(entry) + "\".");
  return messages;
}

} // namespace

ListSpec sampleSpec()
{
  ListSpec output;
  output.name = "Output";
  output.doc = "Files, if any are wanted.";
  output.onlyIfGiven = true;
  output.params = {ParamSpec("Directory", ".", "Where to."), ParamSpec("Exodus", true, "Write NAME.e.")};
  ListSpec library;
  library.name = "Library";
  library.doc = "Handed on.";
  library.passThrough = onlyLevel;
  ListSpec deck;
  deck.name = "deck";
  deck.doc = "A deck for the tests.";
  deck.params = {ParamSpec("Title", "", "One line."),
                 ParamSpec("Pattern", "Right", oneOf({"Right", "Alternating", "Crossed"}), "How squares are cut."),
                 ParamSpec("Fields", std::vector<std::string>{}, oneOf({"stress", "gap"}), "What to write."),
                 ParamSpec("Grading", std::vector<double>{1.0, 1.0}, above(0.0), "Ratio of cell sizes."),
                 ParamSpec::expression("Gap", "0", "Initial distance.")};
  deck.lists = {bodiesSpec(), couplingSpec(), output, library};
  return deck;
}

std::string smallestDeck()
{
  return R"(<ParameterList name="small">
  <ParameterList name="Bodies">
    <ParameterList name="punch">
      <ParameterList name="Material">
        <Parameter name="Type" type="string" value="Isotropic"/>
        <Parameter name="Young Modulus" type="double" value="1"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
</ParameterList>
)";
}

std::string fullDeck()
{
  return R"xml(<?xml version="1.0" encoding="UTF-8"?>
<!-- comments may hold <!DOCTYPE and <Parameter> -->
<ParameterList name="full">
  <Parameter name="Title" type="string" value="Punch &lt;&amp;&quot;&apos;&gt; &#233;"/>
  <Parameter name="Pattern" type="string" value="Crossed"/>
  <Parameter name="Fields" type="Array(string)" value="{stress, gap}"/>
  <Parameter name="Grading" type="Array(int)" value="{1, 2}"/>
  <Parameter name="Gap" type="string" value="0.5*x^2"/>
  <ParameterList name="Bodies">
    <ParameterList name="upper">
      <Parameter name="Cells" type="Array(int)" value="{ 8,8 }"/>
      <Parameter name="Thickness" type="int" value="2"/>
      <ParameterList name="Material">
        <Parameter name="Type" type="string" value="Isotropic"/>
        <Parameter name="Young Modulus" type="double" value="2.1e11"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="lower">
      <Parameter name="Parts" type="Array(string)" value="{}"/>
      <ParameterList name="Material">
        <Parameter name="Type" type="string" value="Orthotropic"/>
        <Parameter name="Young Moduli" type="Array(double)" value="{0.1, 1e300, 3.3333333333333335}"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Coupling">
    <ParameterList name="Relaxation">
      <Parameter name="Type" type="string" value="Aitken"/>
      <ParameterList name="History">
        <Parameter name="Depth" type="int" value="3"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="Stopping">
      <Parameter name="Tolerance" type="double" value="0.1"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Output">
    <Parameter name="Exodus" type="bool" value="false"/>
  </ParameterList>
  <ParameterList name="Library">
    <Parameter name="level" type="int" value="2"/>
  </ParameterList>
</ParameterList>
)xml";
}

Params validated(const std::string& xml, const ListSpec& spec)
{
  Diagnostics diagnostics;
  const Params params = validate(parseDeck(xml, "deck.xml"), spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

std::string complaint(const std::string& xml)
{
  try {
    validated(xml);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

} // namespace ndframe::test
