#include "ndframe/report/summary_text.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"
#include "summary_json.hpp"

// docs/summary.schema.json describes what is written here; tests/report holds the two together.

namespace ndframe
{
namespace
{

template <class Item, class Convert>
Json arrayOf(const std::vector<Item>& items, Convert convert)
{
  auto array = Json::array();
  for (const auto& item : items)
    array.push_back(convert(item));
  return array;
}

Json supportJson(const SupportSummary& support)
{
  return {{"name", support.name},
          {"description", support.description},
          {"force", support.force},
          {"moment", support.moment},
          {"centre", support.centre}};
}

Json peakJson(const PeakSummary& peak)
{
  return {{"value", peak.value}, {"point", peak.point}};
}

Json regionJson(const RegionSummary& region)
{
  return {{"name", region.name}, {"elements", region.elements}, {"energy", region.energy}};
}

Json bodyJson(const BodySummary& body)
{
  Json json{{"name", body.name},
            {"dofs", body.dofs},
            {"elements", body.elements},
            {"order", body.order},
            {"solver", body.solver},
            {"held_by", body.heldBy},
            {"energy", body.energy},
            {"load_force", body.loadForce},
            {"supports", arrayOf(body.supports, supportJson)},
            {"largest_displacement", peakJson(body.displacement)},
            {"largest_strain", peakJson(body.strain)}};
  if (!body.regions.empty())
    json["regions"] = arrayOf(body.regions, regionJson);
  return json;
}

Json warningJson(const WarningSummary& warning)
{
  return {{"kind", warning.kind}, {"message", warning.message}};
}

Json bracketJson(const EndBracket& bracket)
{
  return Json::array({bracket.closed, bracket.open});
}

Json interfaceJson(const InterfaceSummary& interface)
{
  return {{"name", interface.name},
          {"dirichlet_body", interface.dirichletBody},
          {"neumann_body", interface.neumannBody},
          {"nodes", interface.nodes},
          {"closed_nodes", interface.closedNodes},
          {"force_on_dirichlet", interface.forceOnDirichlet},
          {"force_on_neumann", interface.forceOnNeumann},
          {"contact_force", interface.contactForce},
          {interface.isArea ? "contact_area" : "contact_length", interface.contactMeasure},
          {"end_points", interface.endPoints},
          {"end_brackets", arrayOf(interface.endBrackets, bracketJson)},
          {"largest_pressure", interface.largestPressure},
          {"largest_penetration", interface.largestPenetration}};
}

Json sweepJson(const SweepSummary& sweep)
{
  return {{"sweep", sweep.sweep},
          {"eps_tau", sweep.epsTau},
          {"theta", sweep.theta},
          {"status_changes", sweep.statusChanges},
          {"status_passes", sweep.statusPasses},
          {"closed", sweep.closed},
          {"open", sweep.open},
          {"force_on_dirichlet", sweep.forceOnDirichlet},
          {"force_on_neumann", sweep.forceOnNeumann},
          {"penetration", sweep.penetration},
          {"note", sweep.note}};
}

Json roleJson(const RoleSummary& roles)
{
  return {{"dirichlet_bodies", roles.dirichletBodies},
          {"neumann_bodies", roles.neumannBodies},
          {"exchanged", roles.exchanged},
          {"contraction", roles.contraction},
          {"best_theta", roles.bestTheta},
          {"contraction_exchanged", roles.contractionExchanged ? Json(*roles.contractionExchanged) : Json(nullptr)}};
}

Json couplingJson(const std::optional<CouplingSummary>& coupling)
{
  if (!coupling)
    return nullptr;
  return {{"type", coupling->type},
          {"sweeps", coupling->sweeps},
          {"converged", coupling->converged},
          {"reason", coupling->reason},
          {"history", arrayOf(coupling->history, sweepJson)},
          {"roles", arrayOf(coupling->roles, roleJson)}};
}

Json residualsJson(const ResidualSummary& residuals)
{
  return {{"equilibrium", residuals.equilibrium},
          {"complementarity", residuals.complementarity},
          {"penetration", residuals.penetration},
          {"tension", residuals.tension}};
}

Json expectationJson(const ExpectationSummary& expectation)
{
  return {{"name", expectation.name},
          {"value", expectation.value},
          {"expected", expectation.expected},
          {"tolerance", expectation.tolerance},
          {"met", expectation.met}};
}

Json stageJson(const StageSummary& stage)
{
  return {{"name", stage.name}, {"seconds", stage.seconds}, {"peak_bytes", stage.peakBytes}};
}

Json ledgerJson(const RunSummary& summary)
{
  auto counts = Json::object();
  for (const auto& [what, amount] : summary.counts)
    counts[what] = amount;
  return {{"counts", std::move(counts)},
          {"stages", arrayOf(summary.stages, stageJson)},
          {"total_seconds", summary.totalSeconds},
          {"peak_bytes", summary.peakBytes}};
}

Json deckJson(const std::string& text)
{
  auto deck = Json::parse(text, nullptr, false);
  NDFRAME_ASSERT(deck.is_object(), "the effective deck is not a JSON object: " + text);
  return deck;
}

/// Makes the numbers of a solution that does not exist null.
void eraseSolution(Json& json)
{
  json["energy"] = nullptr;
  for (auto& body : json["bodies"])
    for (const auto* key : {"energy", "load_force", "supports", "largest_displacement", "largest_strain"})
      body[key] = nullptr;
  for (auto& interface : json["interfaces"])
    for (const auto* key : {"closed_nodes", "force_on_dirichlet", "force_on_neumann", "contact_force", "contact_length",
                            "contact_area", "end_points", "end_brackets", "largest_pressure", "largest_penetration"})
      if (interface.contains(key))
        interface[key] = nullptr;
  if (json.contains("probes"))
    json["probes"] = nullptr;
  for (auto& residual : json["residuals"])
    residual = nullptr;
  if (auto& coupling = json["coupling"]; coupling.is_object() && coupling["history"].empty())
    coupling["sweeps"] = nullptr;
}

Json buildJson(const BuildInfo& build)
{
  auto libraries = Json::object();
  for (const auto& [name, version] : build.libraries)
    libraries[name] = version;
  return {{"commit", build.commit},
          {"type", build.type},
          {"compiler", build.compiler},
          {"libraries", std::move(libraries)}};
}

const Json* entryByIndex(const Json& array, const std::string& text)
{
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
    return nullptr;
  const auto index = std::size_t(std::stoi(text));
  return index < array.size() ? &array[index] : nullptr;
}

/// The entry of a list whose "name" is `key`; else the one with that index.
const Json* entryOf(const Json& array, const std::string& key)
{
  for (const auto& entry : array)
    if (entry.is_object() && entry.contains("name") && entry["name"] == key)
      return &entry;
  return entryByIndex(array, key);
}

const Json* child(const Json& node, const std::string& key)
{
  if (node.is_array())
    return entryOf(node, key);
  const auto found = node.is_object() ? node.find(key) : node.end();
  return found != node.end() ? &*found : nullptr;
}

std::optional<double> numberOf(const Json& node)
{
  if (node.is_boolean())
    return node.get<bool>() ? 1.0 : 0.0;
  if (node.is_number() && std::isfinite(node.get<double>()))
    return node.get<double>();
  return std::nullopt;
}

} // namespace

Json summaryJson(const RunSummary& summary)
{
  Json json{{"version", summary.version},
            {"build", buildJson(summary.build)},
            {"title", summary.title},
            {"ranks", summary.ranks},
            {"per_unit_thickness", summary.perUnitThickness},
            {"deck", deckJson(summary.deckJson)},
            {"bodies", arrayOf(summary.bodies, bodyJson)},
            {"energy", summary.energy},
            {"interfaces", arrayOf(summary.interfaces, interfaceJson)},
            {"coupling", couplingJson(summary.coupling)},
            {"residuals", residualsJson(summary.residuals)},
            {"warnings", arrayOf(summary.warnings, warningJson)},
            {"errors", errorsJson(summary.errors)},
            {"accuracy", accuracyJson(summary.accuracy)},
            {"expectations", arrayOf(summary.expectations, expectationJson)},
            {"ledger", ledgerJson(summary)}};
  if (!summary.probes.empty())
    json["probes"] = probesJson(summary.probes);
  if (!summary.solved)
    eraseSolution(json);
  return json;
}

std::string toJson(const RunSummary& summary)
{
  // Names in a deck may hold bytes that are not UTF-8; a summary with a replacement character beats none.
  return summaryJson(summary).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::optional<double> summaryValue(const RunSummary& summary, const std::string& path)
{
  const auto root = summaryJson(summary);
  const Json* node = &root;
  for (std::size_t begin = 0; node && begin <= path.size();) {
    const auto end = std::min(path.find('/', begin), path.size());
    node = child(*node, path.substr(begin, end - begin));
    begin = end + 1;
  }
  return node ? numberOf(*node) : std::nullopt;
}

} // namespace ndframe
