#include "ndframe/io/contact_table.hpp"

#include <array>
#include <iterator>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr std::array coordinateNames{"x", "y", "z"};

/// A text cell; quoted as in RFC 4180 when it holds a separator.
std::string quoted(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text)
    result.append(c == '"' ? 2 : 1, c);
  return result + '"';
}

} // namespace

std::string contactCsv(const std::vector<ContactNode>& nodes, int dim)
{
  NDFRAME_ASSERT(dim == 2 || dim == 3, "a contact table is written in 2-D or 3-D");
  fmt::memory_buffer buffer;
  auto out = std::back_inserter(buffer);
  fmt::format_to(out, "interface");
  for (int i = 0; i < dim; ++i)
    fmt::format_to(out, ",{}", coordinateNames[std::size_t(i)]);
  fmt::format_to(out, ",u_dirichlet,u_neumann,gap,traction_dirichlet,traction_neumann,nodal_force,closed\n");
  for (const auto& node : nodes) {
    NDFRAME_ASSERT(int(node.point.size()) == dim, "a contact node has dim coordinates");
    fmt::format_to(out, "{}", quoted(node.interface));
    for (const double x : node.point)
      fmt::format_to(out, ",{:.17g}", x);
    for (const double value :
         {node.uDirichlet, node.uNeumann, node.gap, node.tractionDirichlet, node.tractionNeumann, node.nodalForce})
      fmt::format_to(out, ",{:.17g}", value);
    fmt::format_to(out, ",{:d}\n", int(node.closed));
  }
  return fmt::to_string(buffer);
}

} // namespace ndframe
