#include "ndframe/report/contact_table.hpp"

#include <array>
#include <iterator>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/io/csv.hpp"
#include "ndframe/run/interface_chains.hpp"

namespace ndframe
{
namespace
{

constexpr std::array coordinateNames{"x", "y", "z"};

} // namespace

std::string contactCsv(const std::vector<ContactNode>& nodes, const std::vector<std::string>& interfaces, int dim)
{
  NDFRAME_ASSERT(dim == 2 || dim == 3, "a contact table is written in 2-D or 3-D");
  fmt::memory_buffer buffer;
  auto out = std::back_inserter(buffer);
  fmt::format_to(out, "interface");
  for (int i = 0; i < dim; ++i)
    fmt::format_to(out, ",{}", coordinateNames[std::size_t(i)]);
  fmt::format_to(out, "{},pressure,gap,u_dirichlet,u_neumann,traction_dirichlet,traction_neumann,nodal_force,closed\n",
                 dim == 2 ? ",arc_length" : "");
  for (const auto& node : nodes) {
    NDFRAME_ASSERT(std::size_t(node.interface) < interfaces.size(), "a contact node is of an interface with a name");
    fmt::format_to(out, "{}", csvField(interfaces[std::size_t(node.interface)]));
    for (int i = 0; i < dim; ++i)
      fmt::format_to(out, ",{:.17g}", node.point[std::size_t(i)]);
    if (dim == 2)
      fmt::format_to(out, ",{:.17g}", node.arcLength);
    for (const double value : {node.pressure, node.gap, node.uDirichlet, node.uNeumann, node.tractionDirichlet,
                               node.tractionNeumann, node.nodalForce})
      fmt::format_to(out, ",{:.17g}", value);
    fmt::format_to(out, ",{:d}\n", int(node.closed));
  }
  return fmt::to_string(buffer);
}

std::string contactCsv(const Run& run)
{
  std::vector<std::string> names;
  for (const InterfaceMesh& interface : run.model.interfaces)
    names.push_back(interface.name);
  return contactCsv(sortedAlong(run.model.interfaces, run.solved.contact), names, run.model.bodies.front().mesh.dim);
}

} // namespace ndframe
