#include "ndframe/report/summary_text.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>

#include "report/sample_summaries.hpp"

using namespace ndframe;
using testing::ElementsAre;
using testing::StartsWith;

namespace
{

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// Separators outside of quotes.
std::ptrdiff_t separators(const std::string& line)
{
  bool isQuoted = false;
  return std::count_if(line.begin(), line.end(), [&](char c) {
    isQuoted = isQuoted != (c == '"');
    return c == ',' && !isQuoted;
  });
}

} // namespace

TEST(ProbeTable, HasALineForEveryPointAndSide)
{
  const auto lines = linesOf(probesCsv(test::contactSummary().probes, 2));
  EXPECT_THAT(lines,
              ElementsAre(StartsWith("probe,body,side,point,x,y,u_x,u_y,stress_xx,stress_yy,stress_zz,stress_xy,"
                                     "von_mises,contact_pressure,contact_gap,measure,force_x,force_y,moment"),
                          StartsWith("tip,punch,,0,1,0.5,0.25,-0.125,-1,-2,-0.75,0.5,1.5,,,"),
                          StartsWith("\"a line, with a comma\",punch,,0,1,0.5,"),
                          StartsWith("\"a line, with a comma\",punch,,1,1,0.5,0.25,-0.125,-1,-2,-0.75,0.5,1.5,1.75,0,"),
                          "base,punch,bottom,,1,-1,0,-0.25,,,,,,,,2,0.5,1,-0.125"));
  for (const auto& line : lines)
    EXPECT_EQ(separators(line), separators(lines.front())) << line;
}

TEST(ProbeTable, InSpaceHasAllComponents)
{
  ProbeSummary point, side;
  point.name = side.name = "p";
  point.points.resize(1);
  point.points[0].point = point.points[0].displacement = {1.0, 2.0, 3.0};
  side.side = SideSummary{"top", 1.0, {0, 0, 0}, {0, 0, 0}, {7, 8, 9}, {0, 0, 0}};
  const auto lines = linesOf(probesCsv({point, side}, 3));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(separators(lines[0]), 25);
  EXPECT_EQ(separators(lines[1]), 25);
  EXPECT_THAT(lines[2], testing::EndsWith(",7,8,9"));
  EXPECT_EQ(separators(lines[2]), 25);
}
