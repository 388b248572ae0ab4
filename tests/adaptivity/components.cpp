#include "components.hpp"

namespace ndframe::test
{

std::unique_ptr<Marking> makeMarking(const std::string& type)
{
  Registry<Marking> registry("marking", type);
  registerMarkings(registry);
  return registry.build({"Type=" + type});
}

std::unique_ptr<RefinedMeshes> bisected(const Mesh& mesh)
{
  Registry<Refinement> registry("refinement", "Bisection");
  registerRefinements(registry);
  return registry.build({"Type=Bisection"})->begin({{mesh}, {}, {}}, Comm::single());
}

} // namespace ndframe::test
