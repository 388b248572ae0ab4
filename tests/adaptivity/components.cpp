#include "components.hpp"

namespace ndframe::test
{
namespace
{

/// The parameters of a component that a deck only names.
Params defaults(const Choices& choices, const std::string& type)
{
  ListSpec spec;
  spec.name = "Component";
  spec.choices = choices;
  DeckList list;
  list.name = spec.name;
  Diagnostics diagnostics;
  applySetting(list, "Type=" + type, diagnostics);
  Params params = validate(list, spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

} // namespace

std::unique_ptr<Marking> makeMarking(const std::string& type)
{
  Registry<Marking> registry("marking", type);
  registerMarkings(registry);
  return registry.build(defaults(registry.choices(), type));
}

std::unique_ptr<RefinedMeshes> bisected(const Mesh& mesh)
{
  Registry<Refinement> registry("refinement", "Bisection");
  registerRefinements(registry);
  return registry.build(defaults(registry.choices(), "Bisection"))->begin({{mesh}, {}, {}}, Comm::single());
}

} // namespace ndframe::test
