#include "ndframe/report/screen.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "body_tables.hpp"
#include "ndframe/base/grouped.hpp"
#include "ndframe/condensation/trust.hpp"

namespace ndframe
{
namespace
{

std::size_t nameWidth(const RunSummary& summary)
{
  std::size_t width = 10;
  for (const auto& body : summary.bodies)
    width = std::max(width, body.name.size());
  for (const auto& body : summary.bodies)
    for (const auto& region : body.regions)
      width = std::max(width, region.name.size() + 2); // indented
  for (const auto& interface : summary.interfaces)
    width = std::max(width, interface.name.size());
  return width;
}

std::string sidesText(const InterfaceSummary& interface)
{
  return fmt::format("; Dirichlet side on {}, Neumann side on {}", interface.dirichletBody, interface.neumannBody);
}

std::string endsText(const RunSummary& summary)
{
  std::string text;
  for (const auto& interface : summary.interfaces)
    for (const auto& end : interface.endBrackets)
      text += fmt::format("\n  {}: contact ends between ({:.5g}), closed, and ({:.5g}), open", interface.name,
                          fmt::join(end.closed, ", "), fmt::join(end.open, ", "));
  return text.empty() ? text : "\n" + text;
}

std::string roleText(const RoleSummary& roles)
{
  const auto reason =
      std::isnan(roles.contraction)
          ? "as the deck says: a body's stiffness on the interface is lost in round-off, so nothing can be chosen"
      : !roles.contractionExchanged
          ? fmt::format(
                "contraction {:.2g} with theta {:.2g}; roles are given by nodes where supports hold the other body",
                roles.contraction, roles.theta)
          : fmt::format("chosen: contraction {:.2g} with theta {:.2g}, against {:.2g} with the roles exchanged",
                        roles.contraction, roles.theta, *roles.contractionExchanged);
  return fmt::format("  Dirichlet {}: {} ({})", roles.dirichletBodies.size() == 1 ? "body" : "bodies",
                     fmt::join(roles.dirichletBodies, ", "), reason);
}

/// How far the sides are apart, and whether that was drawn.
std::string gapText(const InterfaceMesh& interface)
{
  const double widest = *std::max_element(interface.gap.begin(), interface.gap.end());
  std::string text = widest > 0.0 ? fmt::format("gap up to {:.3g}", widest) : "no gap";
  if (!interface.map)
    return text;
  if (!interface.drawnGap.empty())
    return text + " with what is drawn";
  const double drawn = interface.map->largestOpening();
  return drawn > 0.0 ? fmt::format("{} (drawn up to {:.2g} apart, ignored)", text, drawn) : text;
}

double areaOf(const Mesh& mesh, const std::vector<Facet>& facets)
{
  double area = 0.0, normal[3];
  for (const Facet facet : facets)
    area += facetNormal(mesh, facet, normal);
  return area;
}

/// The part of a solid's side that lies on the other one, in per cent: of the largest side that has its first facet.
double partOfSide(const Mesh& mesh, const std::vector<Facet>& facets)
{
  double whole = 0.0;
  for (const Side& side : mesh.sides)
    if (std::any_of(side.facets.begin(), side.facets.end(), [&](const Facet facet) {
          return facet.cell == facets.front().cell && facet.local == facets.front().local;
        }))
      whole = std::max(whole, areaOf(mesh, side.facets));
  return 100.0 * areaOf(mesh, facets) / whole;
}

std::string meshText(const InterfaceMesh& interface, const Model& model)
{
  const BodyModel &dirichlet = model.bodies[std::size_t(interface.dirichlet().body)],
                  &neumann = model.bodies[std::size_t(interface.neumann().body)];
  if (neumann.isRigid)
    return "on a rigid body";
  if (!interface.isCut)
    return "matching";
  if (interface.dim == 2)
    return interface.isMortar ? "cut to match, contact in weighted means" : "cut to match";
  return fmt::format("cut to match where sides lie on each other ({:.3g} % of {}'s, {:.3g} % of {}'s)",
                     partOfSide(dirichlet.mesh, interface.dirichlet().facets), dirichlet.name,
                     partOfSide(neumann.mesh, interface.neumann().facets), neumann.name);
}

} // namespace

std::string headerText(const RunSummary& summary, const Model& model, bool rolesAreKnown)
{
  const auto width = nameWidth(summary);
  std::string text =
      fmt::format("  {:<{}} {:>11} {:>11} {:>6}   {:<9}  {}", "body", width, "dofs",
                  model.bodies.front().mesh.dim == 2 ? "triangles" : "tetrahedra", "order", "solver", "held by");
  for (const auto& body : summary.bodies)
    text += fmt::format("\n  {:<{}} {:>11} {:>11} {:>6}   {:<9}  {}", body.name, width, grouped(body.dofs),
                        grouped(body.elements), body.order, body.solver, body.heldBy);
  for (std::size_t i = 0; i < model.interfaces.size(); ++i) {
    const auto& interface = model.interfaces[i];
    text += fmt::format("\n  {:<{}} {:>11} interface nodes, {}, {}{}", interface.name, width,
                        grouped(interface.numNodes()), meshText(interface, model), gapText(interface),
                        rolesAreKnown ? sidesText(summary.interfaces[i]) : "");
  }
  for (const auto& body : model.bodies)
    for (const auto& note : body.mesh.notes)
      text += fmt::format("\n  {:<{}} note: {}", body.name, width, note);
  return text;
}

std::string rolesText(const std::vector<RoleSummary>& roles)
{
  std::string text;
  for (const RoleSummary& part : roles)
    text += (text.empty() ? "" : "\n") + roleText(part);
  return text;
}

std::string sweepTitle(const InterfaceMesh& interface, const Model& model)
{
  const auto on = [&](ContactRole role) {
    return model.interfaces.size() > 1 || interface.touchesItself()
               ? std::string("force on ") + (role == ContactRole::Dirichlet ? "Dirichlet" : "Neumann")
               : "force on " + model.bodies[std::size_t(interface.side(role).body)].name;
  };
  return fmt::format("  sweep    eps_tau   theta     closed/open   changed   {:>18}   {:>18}   penetration",
                     on(ContactRole::Dirichlet), on(ContactRole::Neumann));
}

std::string sweepLine(const SweepRecord& record)
{
  return fmt::format("  {:>5}   {:>8.2e}   {:>5}   {:>12}   {:>7}   {:>18.6g}   {:>18.6g}   {:>11.1e}{}", record.sweep,
                     record.epsTau, record.theta > 0.0 ? fmt::format("{:.3f}", record.theta) : "-",
                     fmt::format("{}/{}", record.closed, record.open), record.statusChanges, record.forceDirichlet,
                     record.forceNeumann, record.penetration, record.note.empty() ? "" : "   " + record.note);
}

std::string closingText(const RunSummary& summary)
{
  const auto width = nameWidth(summary);
  std::string text = bodyTable(summary, width) + "\n\n" + forceTable(summary, width);
  if (!summary.interfaces.empty())
    text += fmt::format("\n\n  {:<{}} {:>14} {:>15} {:>17} {:>12}   {}", "interface", width, "contact force",
                        summary.interfaces.front().isArea ? "contact area" : "contact length", "largest pressure",
                        "penetration", "from - to");
  for (const auto& interface : summary.interfaces) {
    std::string ends;
    for (const auto& point : interface.endPoints)
      ends += fmt::format("{}({:.5g})", ends.empty() ? "" : " - ", fmt::join(point, ", "));
    text += fmt::format("\n  {:<{}} {:>14.6g} {:>15.6g} {:>17.6g} {:>12.1e}   {}", interface.name, width,
                        interface.contactForce, interface.contactMeasure, interface.largestPressure,
                        interface.largestPenetration, ends.empty() ? "no contact" : ends);
  }
  text += endsText(summary);
  const ResidualLimits limits = ResidualLimits::of(summary.residuals);
  text +=
      fmt::format("\n\n  residuals: equilibrium {:.1e} (allowed {:.0e}), complementarity {:.1e}, penetration {:.1e}, "
                  "tension {:.1e} (allowed {:.0e})",
                  summary.residuals.equilibrium, limits.equilibrium, summary.residuals.complementarity,
                  summary.residuals.penetration, summary.residuals.tension, limits.contact);
  return text;
}

std::string stageText(const RunSummary& summary)
{
  std::string text = fmt::format("  {:<19} {:>9} {:>8}", "stage", "seconds", "MB");
  for (const auto& stage : summary.stages)
    text += fmt::format("\n  {:<19} {:>9.3f} {:>8.0f}", stage.name, stage.seconds, double(stage.peakBytes) / 1e6);
  return text;
}

} // namespace ndframe
