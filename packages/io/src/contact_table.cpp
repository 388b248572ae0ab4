#include "ndframe/io/contact_table.hpp"

#include <array>
#include <iterator>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/io/csv.hpp"

namespace ndframe
{
namespace
{

constexpr std::array coordinateNames{"x", "y", "z"};

} // namespace

std::string contactCsv(const std::vector<ContactNode>& nodes, int dim)
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
    NDFRAME_ASSERT(int(node.point.size()) == dim, "a contact node has dim coordinates");
    fmt::format_to(out, "{}", csvField(node.interface));
    for (const double x : node.point)
      fmt::format_to(out, ",{:.17g}", x);
    if (dim == 2)
      fmt::format_to(out, ",{:.17g}", node.arcLength);
    for (const double value : {node.pressure, node.gap, node.uDirichlet, node.uNeumann, node.tractionDirichlet,
                               node.tractionNeumann, node.nodalForce})
      fmt::format_to(out, ",{:.17g}", value);
    fmt::format_to(out, ",{:d}\n", int(node.closed));
  }
  return fmt::to_string(buffer);
}

} // namespace ndframe
