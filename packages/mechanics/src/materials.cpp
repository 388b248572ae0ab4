#include "materials.hpp"

namespace ndframe
{

ParamSpec hypothesisSpec()
{
  return {"Hypothesis", std::string("Plane Strain"), hypothesisNames().range(),
          "How the body is embedded in space: the two plane hypotheses need a two-dimensional mesh, the third a "
          "three-dimensional one."};
}

void registerMaterials(Registry<MaterialLaw>& registry)
{
  registerIsotropic(registry);
  registerOrthotropic(registry);
}

} // namespace ndframe
