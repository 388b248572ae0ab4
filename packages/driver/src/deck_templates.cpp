#include "deck_templates.hpp"

namespace ndframe
{

namespace
{

constexpr const char* twoBodies =
    R"xml(<!-- A block that a pressure presses onto a wider one. Half of a symmetric scene: x = 0 is the plane of symmetry.

     Run it: ndframe two-bodies.xml. Then open two-bodies.e in ParaView, or make a page of the results: ndframe report two-bodies.
     `ndframe -h Bodies` explains a list, `ndframe -h "young modulus"` searches for any words. Use
     any consistent units: with lengths in mm and moduli in MPa, pressures are in MPa. -->
<ParameterList name="two-bodies">
  <Parameter name="Title" type="string" value="A block pressed onto a wider one"/>

  <ParameterList name="Bodies">
    <ParameterList name="upper">
      <!-- A box names its sides left, right, bottom, top. Cells are where the refinement begins. -->
      <ParameterList name="Mesh">
        <Parameter name="Type" type="string" value="Box"/>
        <Parameter name="Lower" type="Array(double)" value="{0.0, 0.0}"/>
        <Parameter name="Upper" type="Array(double)" value="{1.0, 1.0}"/>
        <Parameter name="Cells" type="Array(int)" value="{4, 4}"/>
      </ParameterList>
      <ParameterList name="Material">
        <Parameter name="Young Modulus" type="double" value="2.0"/>
        <Parameter name="Poisson Ratio" type="double" value="0.3"/>
        <!-- Or Plane Stress. -->
        <Parameter name="Hypothesis" type="string" value="Plane Strain"/>
      </ParameterList>
      <ParameterList name="Supports">
        <!-- No displacement along the normal of the side. Nothing but contact holds the block vertically. -->
        <ParameterList name="symmetry">
          <Parameter name="Type" type="string" value="Roller"/>
          <Parameter name="Side" type="string" value="left"/>
        </ParameterList>
      </ParameterList>
      <ParameterList name="Loads">
        <!-- On the boundary, against the normal; an expression in x and y works, too: "0.01 * (1 + x)". -->
        <ParameterList name="press">
          <Parameter name="Type" type="string" value="Pressure"/>
          <Parameter name="Side" type="string" value="top"/>
          <Parameter name="Value" type="double" value="0.01"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>

    <ParameterList name="lower">
      <ParameterList name="Mesh">
        <Parameter name="Type" type="string" value="Box"/>
        <Parameter name="Lower" type="Array(double)" value="{0.0, -1.0}"/>
        <Parameter name="Upper" type="Array(double)" value="{2.0, 0.0}"/>
        <Parameter name="Cells" type="Array(int)" value="{8, 4}"/>
      </ParameterList>
      <ParameterList name="Material">
        <Parameter name="Young Modulus" type="double" value="1.0"/>
        <Parameter name="Poisson Ratio" type="double" value="0.3"/>
      </ParameterList>
      <ParameterList name="Supports">
        <ParameterList name="symmetry">
          <Parameter name="Type" type="string" value="Roller"/>
          <Parameter name="Side" type="string" value="left"/>
        </ParameterList>
        <!-- No displacement at all. -->
        <ParameterList name="ground">
          <Parameter name="Type" type="string" value="Clamp"/>
          <Parameter name="Side" type="string" value="bottom"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>
  </ParameterList>

  <ParameterList name="Interfaces">
    <!-- Two sides that may touch; their meshes and lengths may differ. Parts that face nothing carry nothing. -->
    <ParameterList name="contact">
      <Parameter name="Dirichlet Body" type="string" value="upper"/>
      <Parameter name="Dirichlet Side" type="string" value="bottom"/>
      <Parameter name="Neumann Body" type="string" value="lower"/>
      <Parameter name="Neumann Side" type="string" value="top"/>
    </ParameterList>
  </ParameterList>

  <!-- The error that you accept, guaranteed: meshes are refined until the bound is below it. Without this list there is one
       run on the meshes above; a list Error Estimation then says how wrong it is. -->
  <ParameterList name="Accuracy">
    <Parameter name="Target" type="double" value="0.05"/>
  </ParameterList>
</ParameterList>
)xml";

constexpr const char* hertz =
    R"xml(<!-- A cylinder of radius 1 on a block of the same material, plane strain. The round side is a straight one with the gap x^2 / 2R.
     Hertz: a = sqrt(4 P R / (pi E*)), p0 = 2 P / (pi a), E* = E / (2 (1 - nu^2)). Pressure 0.002 on the top: P = 0.004, a = 0.0963,
     p0 = 0.0265, for bodies that are large compared with a.

     Run it: ndframe hertz.xml. Then open hertz.e in ParaView, or make a page of the results: ndframe report hertz.
     `ndframe -h Bodies` explains a list, `ndframe -h "young modulus"` searches for any words. Use
     any consistent units: with lengths in mm and moduli in MPa, pressures are in MPa. -->
<ParameterList name="hertz">
  <Parameter name="Title" type="string" value="A cylinder on a block (Hertz)"/>

  <ParameterList name="Bodies">
    <!-- Half of the cylinder; x = 0 is the plane of symmetry. -->
    <ParameterList name="cylinder">
      <ParameterList name="Mesh">
        <Parameter name="Type" type="string" value="Box"/>
        <Parameter name="Lower" type="Array(double)" value="{0.0, 0.0}"/>
        <Parameter name="Upper" type="Array(double)" value="{1.0, 1.0}"/>
        <Parameter name="Cells" type="Array(int)" value="{8, 8}"/>
      </ParameterList>
      <ParameterList name="Material">
        <Parameter name="Young Modulus" type="double" value="1.0"/>
        <Parameter name="Poisson Ratio" type="double" value="0.3"/>
      </ParameterList>
      <ParameterList name="Supports">
        <ParameterList name="symmetry">
          <Parameter name="Type" type="string" value="Roller"/>
          <Parameter name="Side" type="string" value="left"/>
        </ParameterList>
      </ParameterList>
      <ParameterList name="Loads">
        <!-- P = 2 * 0.002 * 1, for both halves. -->
        <ParameterList name="press">
          <Parameter name="Type" type="string" value="Pressure"/>
          <Parameter name="Side" type="string" value="top"/>
          <Parameter name="Value" type="double" value="0.002"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>

    <ParameterList name="block">
      <ParameterList name="Mesh">
        <Parameter name="Type" type="string" value="Box"/>
        <Parameter name="Lower" type="Array(double)" value="{0.0, -1.0}"/>
        <Parameter name="Upper" type="Array(double)" value="{1.0, 0.0}"/>
        <Parameter name="Cells" type="Array(int)" value="{8, 8}"/>
      </ParameterList>
      <ParameterList name="Material">
        <Parameter name="Young Modulus" type="double" value="1.0"/>
        <Parameter name="Poisson Ratio" type="double" value="0.3"/>
      </ParameterList>
      <ParameterList name="Supports">
        <ParameterList name="symmetry">
          <Parameter name="Type" type="string" value="Roller"/>
          <Parameter name="Side" type="string" value="left"/>
        </ParameterList>
        <ParameterList name="ground">
          <Parameter name="Type" type="string" value="Roller"/>
          <Parameter name="Side" type="string" value="bottom"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>
  </ParameterList>

  <ParameterList name="Interfaces">
    <!-- Gap is added to the drawn distance of the sides: an expression in x and y. -->
    <ParameterList name="contact">
      <Parameter name="Dirichlet Body" type="string" value="cylinder"/>
      <Parameter name="Dirichlet Side" type="string" value="bottom"/>
      <Parameter name="Neumann Body" type="string" value="block"/>
      <Parameter name="Neumann Side" type="string" value="top"/>
      <Parameter name="Gap" type="string" value="0.5 * x^2"/>
    </ParameterList>
  </ParameterList>

  <!-- The error that you accept, guaranteed: meshes are refined until the bound is below it. Without this list there is one
       run on the meshes above; a list Error Estimation then says how wrong it is. -->
  <ParameterList name="Accuracy">
    <Parameter name="Target" type="double" value="0.02"/>
  </ParameterList>

  <!-- Expected results; a miss is exit code 4. -->
  <ParameterList name="Expect">
    <ParameterList name="the peak pressure is that of Hertz, up to the size of the bodies">
      <Parameter name="Quantity" type="string" value="interfaces/contact/largest_pressure"/>
      <Parameter name="Value" type="double" value="0.0265"/>
      <Parameter name="Tolerance" type="double" value="0.0015"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";

constexpr const char* obstacle =
    R"xml(<!-- An elastic block on a rigid cylinder. A body that does not deform needs no mesh and no material, only its shape.

     Run it: ndframe obstacle.xml. Then open obstacle.e in ParaView, or make a page of the results: ndframe report obstacle.
     `ndframe -h Bodies` explains a list, `ndframe -h "young modulus"` searches for any words. Use
     any consistent units: with lengths in mm and moduli in MPa, pressures are in MPa. -->
<ParameterList name="obstacle">
  <Parameter name="Title" type="string" value="A block on a rigid cylinder"/>

  <ParameterList name="Bodies">
    <ParameterList name="block">
      <ParameterList name="Mesh">
        <Parameter name="Type" type="string" value="Box"/>
        <Parameter name="Lower" type="Array(double)" value="{0.0, 0.0}"/>
        <Parameter name="Upper" type="Array(double)" value="{1.0, 1.0}"/>
        <Parameter name="Cells" type="Array(int)" value="{8, 8}"/>
      </ParameterList>
      <ParameterList name="Material">
        <Parameter name="Young Modulus" type="double" value="1.0"/>
        <Parameter name="Poisson Ratio" type="double" value="0.3"/>
        <!-- Or Plane Stress. -->
        <Parameter name="Hypothesis" type="string" value="Plane Strain"/>
      </ParameterList>
      <ParameterList name="Supports">
        <!-- x = 0 is the plane of symmetry. -->
        <ParameterList name="symmetry">
          <Parameter name="Type" type="string" value="Roller"/>
          <Parameter name="Side" type="string" value="left"/>
        </ParameterList>
      </ParameterList>
      <ParameterList name="Loads">
        <!-- Presses the block onto the cylinder, which alone holds it vertically. -->
        <ParameterList name="press">
          <Parameter name="Type" type="string" value="Pressure"/>
          <Parameter name="Side" type="string" value="top"/>
          <Parameter name="Value" type="double" value="0.002"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>

    <ParameterList name="cylinder">
      <!-- Or Plane, or Expression for the distance; Displacement moves it (`ndframe -h Rigid`). -->
      <ParameterList name="Rigid">
        <Parameter name="Type" type="string" value="Cylinder"/>
        <Parameter name="Centre" type="Array(double)" value="{0.0, -2.0}"/>
        <Parameter name="Radius" type="double" value="2.0"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>

  <ParameterList name="Interfaces">
    <!-- The block's side that may touch; a rigid body has no sides. -->
    <ParameterList name="contact">
      <Parameter name="Dirichlet Body" type="string" value="block"/>
      <Parameter name="Dirichlet Side" type="string" value="bottom"/>
      <Parameter name="Neumann Body" type="string" value="cylinder"/>
    </ParameterList>
  </ParameterList>

  <!-- The error that you accept, guaranteed: meshes are refined until the bound is below it. Without this list there is one
       run on the meshes above; a list Error Estimation then says how wrong it is. -->
  <ParameterList name="Accuracy">
    <Parameter name="Target" type="double" value="0.02"/>
  </ParameterList>
</ParameterList>
)xml";

} // namespace

const std::vector<DeckTemplate>& deckTemplates()
{
  static const std::vector<DeckTemplate> all{
      {"two-bodies", "a block pressed onto a wider one", twoBodies},
      {"hertz", "a cylinder on a block, compared with Hertz: the curved side as a gap", hertz},
      {"obstacle", "an elastic block on a rigid cylinder", obstacle}};
  return all;
}

} // namespace ndframe
