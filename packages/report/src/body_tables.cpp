#include "body_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{
namespace
{

/// Forces below this part of the scene's largest are round-off and shown as 0.
constexpr double roundOff = 1e-12;

double largestForce(const RunSummary& summary)
{
  double largest = 0.0;
  const auto look = [&](const std::vector<double>& force) {
    for (const double component : force)
      largest = std::max(largest, std::abs(component));
  };
  for (const auto& body : summary.bodies) {
    look(body.loadForce);
    for (const auto& support : body.supports)
      look(support.force);
  }
  for (const auto& interface : summary.interfaces)
    look(interface.forceOnDirichlet);
  return largest;
}

std::string vectorText(std::vector<double> values, double nothing)
{
  for (double& value : values)
    value = std::abs(value) <= nothing ? 0.0 : value;
  return fmt::format("({:.5g})", fmt::join(values, ", "));
}

std::string regionRows(const BodySummary& body, std::size_t nameWidth)
{
  std::string text;
  for (const auto& region : body.regions)
    text += fmt::format("\n  {:<{}} {:>18.8g}", "  " + (region.name.empty() ? "rest" : region.name), nameWidth,
                        region.energy);
  return text;
}

} // namespace

std::string bodyTable(const RunSummary& summary, std::size_t nameWidth)
{
  const auto at = [](const PeakSummary& peak) { return vectorText(peak.point, 0.0); };
  std::size_t placeWidth = 2;
  for (const auto& body : summary.bodies)
    placeWidth = std::max({placeWidth, at(body.displacement).size(), at(body.strain).size()});
  std::string text = fmt::format("  {:<{}} {:>18}   {:>20} {:<{}}   {:>14} at", "body", nameWidth, "energy a(u,u)",
                                 "largest displacement", "at", placeWidth, "largest strain");
  for (const auto& body : summary.bodies) {
    text += fmt::format("\n  {:<{}} {:>18.8g}   {:>20.6g} {:<{}}   {:>14.4g} {}", body.name, nameWidth, body.energy,
                        body.displacement.value, at(body.displacement), placeWidth, body.strain.value, at(body.strain));
    text += regionRows(body, nameWidth);
  }
  if (summary.bodies.size() > 1)
    text += fmt::format("\n  {:<{}} {:>18.8g}", "all", nameWidth, summary.energy);
  return text;
}

std::string forceTable(const RunSummary& summary, std::size_t nameWidth)
{
  const double nothing = roundOff * largestForce(summary);
  std::vector<std::array<std::string, 3>> rows; // body, what, force and moment
  for (const auto& body : summary.bodies) {
    const auto add = [&](const std::string& what, const std::string& force) {
      rows.push_back({body.name, what, force});
    };
    if (body.dofs > 0) // nothing loads a rigid one
      add("loads", vectorText(body.loadForce, nothing));
    for (const auto& support : body.supports)
      add(support.description, fmt::format("{}   moment {} about {}", vectorText(support.force, nothing),
                                           vectorText(support.moment, nothing), vectorText(support.centre, 0.0)));
    for (const auto& interface : summary.interfaces) {
      const bool isItself = interface.dirichletBody == interface.neumannBody;
      const std::string name = "interface " + interface.name;
      if (interface.dirichletBody == body.name)
        add(isItself ? name + ", Dirichlet side" : name, vectorText(interface.forceOnDirichlet, nothing));
      if (interface.neumannBody == body.name)
        add(isItself ? name + ", Neumann side" : name, vectorText(interface.forceOnNeumann, nothing));
    }
  }
  std::size_t width = 5;
  for (const auto& row : rows)
    width = std::max(width, row[1].size());
  std::string text = fmt::format("  {:<{}} {:<{}}   force{}", "body", nameWidth, "by", width,
                                 summary.perUnitThickness ? " (plane scene: per unit thickness)" : "");
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += fmt::format("\n  {:<{}} {:<{}}   {}", i > 0 && rows[i][0] == rows[i - 1][0] ? "" : rows[i][0], nameWidth,
                        rows[i][1], width, rows[i][2]);
  return text;
}

} // namespace ndframe
