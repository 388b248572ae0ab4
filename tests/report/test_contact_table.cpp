#include "ndframe/report/contact_table.hpp"

#include <array>
#include <sstream>

#include <gmock/gmock.h>

#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;

namespace
{

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

const std::vector<std::string> names{"contact", "left, \"inner\""};

ContactNode sampleNode(const std::array<double, 3>& point)
{
  ContactNode node;
  node.point = point;
  node.uDirichlet = 1.0 / 3.0;
  node.uNeumann = -1e-300;
  node.gap = 0.1;
  node.tractionDirichlet = -1.75e9;
  node.tractionNeumann = -1.0;
  node.nodalForce = -0.0625;
  node.pressure = 1.5e9;
  node.closed = true;
  return node;
}

} // namespace

TEST(ContactTable, NamesItsColumnsInTheFirstLine)
{
  EXPECT_EQ(contactCsv({}, names, 2), "interface,x,y,arc_length,pressure,gap,u_dirichlet,u_neumann,traction_dirichlet,"
                                      "traction_neumann,nodal_force,closed\n");
  EXPECT_EQ(split(contactCsv({}, names, 3), ',').size(), 12U);
}

TEST(ContactTable, NumbersReadBackExactly)
{
  const auto node = sampleNode({0.1, 2.0 / 3.0, -7.0});
  const auto lines = split(contactCsv({node}, names, 3), '\n');
  ASSERT_EQ(lines.size(), 2U);
  const auto cells = split(lines[1], ',');
  ASSERT_EQ(cells.size(), 12U);
  EXPECT_EQ(cells[0], "contact");
  std::vector<double> values;
  for (std::size_t i = 1; i < 11; ++i)
    values.push_back(std::stod(cells[i]));
  EXPECT_THAT(values,
              testing::ElementsAre(0.1, 2.0 / 3.0, -7.0, node.pressure, node.gap, node.uDirichlet, node.uNeumann,
                                   node.tractionDirichlet, node.tractionNeumann, node.nodalForce));
  EXPECT_EQ(cells[11], "1");
}

TEST(ContactTable, HasOneLinePerNodeInTheOrderGiven)
{
  auto open = sampleNode({2.0, 0.0});
  open.closed = false;
  const auto lines = split(contactCsv({sampleNode({3.0, 0.0}), open}, names, 2), '\n');
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[1], testing::AllOf(testing::StartsWith("contact,3,0,"), testing::EndsWith(",1")));
  EXPECT_THAT(lines[2], testing::AllOf(testing::StartsWith("contact,2,0,"), testing::EndsWith(",0")));
}

TEST(ContactTable, QuotesNamesThatHoldSeparators)
{
  auto node = sampleNode({0.0, 0.0});
  node.interface = 1;
  EXPECT_THAT(contactCsv({node}, names, 2), testing::HasSubstr("\n\"left, \"\"inner\"\"\",0,0,"));
}

TEST(ContactTable, WantsANameForEveryInterface)
{
  EXPECT_THROW(contactCsv({sampleNode({0.0, 0.0})}, {}, 2), InternalError);
}
