#include "ndframe/run/contact_start.hpp"

#include "ndframe/interface/traction_transfer.hpp"

namespace ndframe
{

InterfaceValues nextTraction(const Run& run)
{
  if (run.model.interfaces.empty())
    return {};
  const CouplingResult& coupling = run.solved.coupling;
  const double theta = coupling.history.back().theta;
  const std::vector<char> closed = statusesOfNodes(run.condensed.interface, coupling.state.closed);
  InterfaceValues traction = coupling.state.tractionNeumann;
  for (std::size_t i = 0; i < traction.size(); ++i)
    traction[i] = closed[i] ? traction[i] + theta * (coupling.state.tractionDirichlet[i] - traction[i]) : 0.0;
  return traction;
}

CarriedContact contactOf(const Run& run, InterfaceValues traction)
{
  if (run.model.interfaces.empty())
    return {};
  return {run.model.interfaces, std::move(traction),
          statusesOfNodes(run.condensed.interface, run.solved.coupling.state.closed)};
}

CouplingStart startFrom(const Run& run, const CarriedContact& contact)
{
  CouplingStart start;
  start.traction = contact.traction;
  if (!contact.closed.empty())
    start.closed = statusesOfUnknowns(run.condensed.interface, contact.closed);
  return start;
}

CouplingStart startLike(const Run& run, const CarriedContact& contact)
{
  const auto numNodes = [](const std::vector<InterfaceMesh>& interfaces) {
    std::vector<int> numbers;
    for (const auto& interface : interfaces)
      numbers.push_back(interface.numNodes());
    return numbers;
  };
  const bool fits = !contact.closed.empty() && numNodes(contact.interfaces) == numNodes(run.model.interfaces);
  return fits ? startFrom(run, contact) : CouplingStart();
}

} // namespace ndframe
