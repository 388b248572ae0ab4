#include "ndframe/driver/deck_spec.hpp"

namespace ndframe
{

namespace
{

constexpr const char* text = R"xml(<ParameterList name="default">
  <Parameter name="Title" type="string" value="Two blocks pressed together"/>
  <ParameterList name="Bodies">
    <ParameterList name="upper">
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
        <Parameter name="Upper" type="Array(double)" value="{1.0, 0.0}"/>
        <Parameter name="Cells" type="Array(int)" value="{8, 8}"/>
      </ParameterList>
      <ParameterList name="Material">
        <Parameter name="Young Modulus" type="double" value="1.0"/>
        <Parameter name="Poisson Ratio" type="double" value="0.3"/>
      </ParameterList>
      <ParameterList name="Supports">
        <ParameterList name="ground">
          <Parameter name="Type" type="string" value="Clamp"/>
          <Parameter name="Side" type="string" value="bottom"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Interfaces">
    <ParameterList name="contact">
      <Parameter name="Dirichlet Body" type="string" value="upper"/>
      <Parameter name="Dirichlet Side" type="string" value="bottom"/>
      <Parameter name="Neumann Body" type="string" value="lower"/>
      <Parameter name="Neumann Side" type="string" value="top"/>
    </ParameterList>
  </ParameterList>
  <Parameter name="Strain Limit" type="double" value="10.0"/>
</ParameterList>
)xml";

} // namespace

std::string defaultDeck()
{
  return text;
}

} // namespace ndframe
