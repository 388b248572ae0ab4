// Makes the mesh of a box from a list of the deck, as a body's list "Mesh" describes it.
#include <cmath>

#include "ndframe/meshing/mesh_source.hpp"

int main()
{
  using namespace ndframe;
  Registry<MeshSource> sources("mesh");
  registerMeshSources(sources);
  ListSpec spec;
  spec.choices = sources.choices();

  const char* const xml = R"xml(
    <ParameterList name="Mesh">
      <Parameter name="Type"   type="string"        value="Box"/>
      <Parameter name="Lower"  type="Array(double)" value="{0, 0, 0}"/>
      <Parameter name="Upper"  type="Array(double)" value="{4, 2, 1}"/>
      <Parameter name="Cells"  type="Array(int)"    value="{4, 2, 1}"/>
      <Parameter name="Refine" type="int"           value="1"/>
    </ParameterList>)xml";
  Diagnostics mistakes;
  const Params list = validate(parseDeck(xml, "box.xml"), spec, mistakes);
  mistakes.throwIfAny();
  const Mesh mesh = sources.build(list)->read();

  double volume = 0.0, top = 0.0, normal[3];
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    volume += cellMeasure(mesh, cell);
  for (const Facet& facet : mesh.findSide("top")->facets)
    top += facetNormal(mesh, facet, normal); // the area
  const int cells = 4 * 2 * 1 * 6 * 8;       // six tetrahedra a box, eight of each with halved edges
  return mesh.numCells() == cells && std::abs(volume - 8.0) < 1e-12 && std::abs(top - 8.0) < 1e-14 ? 0 : 1;
}
