#include "ndframe/driver/deck_spec.hpp"

#include "accuracy_list.hpp"
#include "automatic_list.hpp"
#include "error_list.hpp"
#include "load_cases.hpp"
#include "ndframe/base/list_specs.hpp"
#include "ndframe/run/warnings.hpp"
#include "output_list.hpp"
#include "study_cases.hpp"

namespace ndframe
{
namespace
{

/// A list whose sublists the user names, all of one shape.
ListSpec makeNamed(std::string name, std::string doc, ListSpec each)
{
  ListSpec list = makeList(std::move(name), std::move(doc));
  list.each = std::make_shared<ListSpec>(std::move(each));
  return list;
}

ListSpec regionSpec(const ListSpec& material)
{
  ListSpec region = makeList("REGION", "Cells of the body and what they are made of.");
  region.params = {{"Cells", std::vector<std::string>{},
                    "Groups of cells of the mesh: physical groups of gmsh, element blocks of Exodus, Parts of a box. "
                    "Empty: the group that has the region's name. Cells in no region have the body's Material."}};
  region.lists = {material};
  return region;
}

ListSpec bodySpec(const Components& components)
{
  ListSpec body = makeList("BODY", "One elastic body; the list's name is the body's name.");
  ListSpec mesh = makeChoice("Mesh", "Where the mesh comes from.", components.meshSources.choices());
  ListSpec material = makeChoice("Material", "The elastic law.", components.materials.choices());
  mesh.isRequired = material.isRequired = true;
  ListSpec rigid = makeChoice("Rigid",
                              "In place of Mesh and Material: an obstacle that does not deform, given by a formula. "
                              "Sides of other bodies touch it (Interfaces, as Neumann Body); it needs no mesh.",
                              components.obstacles.choices());
  rigid.onlyIfGiven = true;
  mesh.requiredUnless = {rigid.name};
  ListSpec regions =
      makeNamed("Regions", "Parts of the body with their own materials, one named list each.", regionSpec(material));
  regions.onlyIfGiven = true;
  material.requiredUnless = {regions.name, rigid.name};
  body.lists = {std::move(mesh),
                std::move(material),
                std::move(regions),
                std::move(rigid),
                makeNamed("Supports",
                          "Prescribed displacements, one named list each. A body held by contact needs supports only "
                          "for what contact cannot hold.",
                          makeChoice("SUPPORT", "One support.", components.supports.choices())),
                makeNamed("Loads", "Forces on the body, one named list each; they add up.",
                          makeChoice("LOAD", "One load.", components.loads.choices()))};
  return body;
}

ListSpec interfaceSpec()
{
  ListSpec list = makeList(
      "INTERFACE", "Two sides that may touch. Their meshes need not match; bent sides of solids need common nodes.");
  list.params = {
      ParamSpec::required("Dirichlet Body", Kind::String,
                          "Body 1 of the paper: solves the unilateral problem; may float, held only by contact."),
      ParamSpec::required("Dirichlet Side", Kind::String, "Its side; the outward normal there is n_c."),
      ParamSpec::required("Neumann Body", Kind::String,
                          "Body 2 of the paper: receives the contact traction; may float, too. The Dirichlet body "
                          "again for self-contact: two sides of one body."),
      ParamSpec::optional("Neumann Side", Kind::String, "Its side; required unless the body is Rigid."),
      {"Tied", false,
       "The sides are glued where they face each other, in normal and tangential direction: no contact; the two bodies "
       "become one with a region each, called \"BODY + BODY\". Bent sides of solids need common nodes."},
      ParamSpec::expression("Gap", "0",
                            "Opening g >= 0 between the sides along n_c before loading, a length: u1_N - u2_N <= g, in "
                            "addition to that of the geometry."),
      {"Gap From Geometry", std::string("Automatic"), drawnGapNames().range(),
       "Whether the drawn distance between the sides, along n_c, is part of the gap. Automatic: yes, unless the sides "
       "touch everywhere except for the distance between chords of one curve. No: points that face each other touch."},
      {"Corner Angle", 35.0, inClosedRange(0.0, 180.0),
       "In degrees. Where the side's facets meet at a smaller angle on the first mesh, they represent a curve, and n_c "
       "turns along them from vertex to vertex; at a larger one each facet keeps its own normal, and the corner has "
       "the conditions of both (in solids one, along the mean). 0: all facets keep their own, with one condition per "
       "vertex, along the mean."}};
  ListSpec pairing = makeList("Pairing", "How sides in the plane whose meshes do not match are brought together.");
  pairing.params = {
      {"Type", std::string("Cut"), oneOf({"Cut", "Mortar"}),
       "Both meshes are cut at the vertices of the other side. Cut: contact is asked at all nodes of the cut sides. "
       "Mortar: in weighted means, with tractions that are polynomials on the facets, as they were, of the side that "
       "has more of them; short pieces do not show in the pressure, and between the means sides may penetrate. Needs "
       "the coupling Monolithic, FETI or Neumann-Neumann. The same where the meshes match."}};
  list.lists = {std::move(pairing)};
  return list;
}

ListSpec interfacesSpec()
{
  ListSpec list =
      makeNamed("Interfaces", "Where bodies may touch. Without it every body is solved alone.", interfaceSpec());
  list.lists = {automaticSpec(*list.each)};
  return list;
}

} // namespace

ListSpec makeDeckSpec(const Components& components)
{
  ListSpec deck =
      makeList("", "The deck. Use any consistent units: with lengths in mm and moduli in MPa (N/mm^2), pressures and "
                   "stresses are in MPa, forces in N, energies in N mm; with m and Pa, they are in Pa, N and N m. In "
                   "plane scenes forces and energies are those of a slice of thickness 1.");
  deck.params = {
      {"Title", std::string(""), "One line that describes the scene; shown on the screen and in the results."}};
  for (auto& param : warningParams())
    deck.params.push_back(std::move(param));
  ListSpec bodies = makeNamed("Bodies", "The elastic bodies.", bodySpec(components));
  bodies.isRequired = true;
  ListSpec discretization = makeList("Discretization", "The finite elements.");
  discretization.params = {
      {"Order", 2, inClosedRange(1, 2), "Degree of the displacements on every simplex."},
      {"Contact Conditions", std::string("Automatic"), oneOf({"Automatic", "Nodal", "Bernstein"}),
       "Where contact is enforced on bodies of second order. Nodal: at the nodes; between them bodies may penetrate, "
       "and in 3D vertices carry no load. Bernstein: on the Bernstein coefficients of the gap on each facet, so that "
       "no point of a straight side penetrates; bounds on coarse meshes with open contact are smaller. Automatic: "
       "Bernstein in 3D, Nodal in 2D."}};
  deck.lists = {std::move(bodies),
                interfacesSpec(),
                std::move(discretization),
                makeChoice("Coupling", "How the bodies are coupled.", components.couplings.choices()),
                makeChoice("Linear Solver", "How each body's matrix is factored.", components.linearSolvers.choices()),
                makeChoice("Interface Operator", "How the bodies' Schur complements on the interface are represented.",
                           components.interfaceOperators.choices()),
                errorEstimationSpec(components.recoveries.choices()),
                accuracySpec(components),
                outputSpec(),
                makeNamed("Expect", "Numbers checked at the end of the run.", expectationSpec()),
                loadCasesSpec(),
                studySpec()};
  return deck;
}

} // namespace ndframe
