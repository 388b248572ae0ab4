#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "error_fields.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/exodus_writer.hpp"
#include "ndframe/report/html_report.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/run/interface_chains.hpp"
#include "ndframe/run/run.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/gap_offset.hpp"
#include "ndframe/scene/stage.hpp"
#include "stress_fields.hpp"

namespace ndframe
{
namespace
{

constexpr std::array<const char*, 3> axisNames{"x", "y", "z"};
constexpr const char *fieldsEnding = ".e", *contactEnding = ".contact.csv", *levelsEnding = ".levels.csv",
                     *probesEnding = ".probes.csv";

/// A vector as the variables PREFIXx, PREFIXy(, PREFIXz).
std::vector<NamedField> vectorFields(const std::string& prefix, const Vector& values, std::size_t dim)
{
  std::vector<NamedField> fields;
  for (std::size_t k = 0; k < dim; ++k) {
    fields.push_back({prefix + axisNames.at(k), {}});
    for (std::size_t i = k; i < values.size(); i += dim)
      fields.back().values.push_back(values[i]);
  }
  return fields;
}

/// Means of the basis functions over a facet: int N_a dS / measure.
std::vector<double> facetWeights(const InterfaceMesh& interface)
{
  const auto rule = simplexRule(interface.dim - 1, interface.order);
  return withDimAndOrder(interface.dim, interface.order, [&](auto d, auto p) {
    using Basis = Lagrange<d() - 1, p()>;
    std::vector<double> weights(std::size_t(Basis::nodes), 0.0);
    double N[Basis::nodes];
    for (int q = 0; q < rule.size(); ++q) {
      Basis::values(rule.point(q), N);
      for (int a = 0; a < Basis::nodes; ++a)
        weights[std::size_t(a)] += rule.weights[std::size_t(q)] * N[a];
    }
    return weights;
  });
}

/// Mean pressure of one side (`traction`: Lambda_dir or Lambda_neu) and mean gap of every facet; status 1 where all
/// nodes are closed.
std::vector<NamedField> contactFields(const InterfaceMesh& interface, const std::vector<ContactNode>& contact,
                                      std::size_t firstNode, double ContactNode::*traction)
{
  std::vector<NamedField> fields{{"contact_pressure", {}}, {"contact_gap", {}}, {"contact_status", {}}};
  const auto weights = facetWeights(interface);
  for (std::size_t f = 0; f < std::size_t(interface.numFacets()); ++f) {
    double pressure = 0.0, gap = 0.0, closed = 1.0;
    for (std::size_t a = 0; a < weights.size(); ++a) {
      const auto& node = contact[firstNode + std::size_t(interface.facets[f * weights.size() + a])];
      pressure -= weights[a] * node.*traction;
      gap += weights[a] * node.gap;
      closed = node.closed ? closed : 0.0;
    }
    fields[0].values.push_back(pressure);
    fields[1].values.push_back(gap);
    fields[2].values.push_back(closed);
  }
  return fields;
}

/// Contact pressure at the interface nodes of one body, the same on both sides; zero elsewhere.
NamedField nodalPressure(const Run& run, std::size_t body, const std::vector<ContactNode>& contact)
{
  NamedField field{"contact_pressure", Vector(std::size_t(run.model.bodies[body].nodes.numNodes()), 0.0)};
  std::size_t firstNode = 0;
  for (const auto& interface : run.model.interfaces) {
    for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i) {
      for (const auto& [side, nodes] : {std::pair(interface.dirichletBody, &interface.dirichletNodes),
                                        std::pair(interface.neumannBody, &interface.neumannNodes)})
        if (side == int(body)) {
          double& value = field.values[std::size_t((*nodes)[i])];
          value = std::max(value, contact[firstNode + i].pressure); // a corner has one on each side of it
        }
    }
    firstNode += std::size_t(interface.numNodes());
  }
  return field;
}

ExodusStep exodusStep(const Run& run, const OutputOptions& output, std::size_t step)
{
  ExodusStep out;
  const bool touches = !run.model.interfaces.empty();
  const bool isFinal = step + 1 == run.solved.states.size();
  const std::size_t sweep = !touches ? 0 : (isFinal ? run.solved.coupling.history.size() : step + 1);
  out.time = double(sweep);
  const auto contact = contactNodes(run.model, run.condensed, run.solved.states[step], run.solved.fields, step);
  const auto offsets = gapOffsets(run.model);
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const Vector u = run.condensed.systems[b].dofs.frames.toGlobal(run.solved.fields[b].u[step]);
    out.nodal.push_back(vectorFields("disp_", run.solved.fields[b].displacement[step], std::size_t(body.mesh.dim)));
    if (!offsets.empty())
      append(out.nodal.back(), vectorFields("offset_", offsets[b], std::size_t(body.mesh.dim)));
    if (touches)
      out.nodal.back().push_back(nodalPressure(run, b, contact));
    append(out.nodal.back(), nodalStressFields(body, u));
    out.element.push_back(cellStressFields(body, u));
    append(out.element.back(), elementErrorFields(run, output, b, isFinal));
  }
  std::size_t firstNode = 0;
  for (std::size_t i = 0; i < run.model.interfaces.size(); ++i) {
    const auto& interface = run.model.interfaces[i];
    for (const auto traction : {&ContactNode::tractionDirichlet, &ContactNode::tractionNeumann}) {
      out.contactSide.push_back(contactFields(interface, contact, firstNode, traction));
      append(out.contactSide.back(), admissiblePressure(run, i, isFinal));
    }
    firstNode += std::size_t(interface.numNodes());
  }
  if (touches)
    out.global = {{"eps_tau", {run.solved.coupling.history[sweep - 1].epsTau}},
                  {"converged", {isFinal && run.solved.coupling.converged ? 1.0 : 0.0}}};
  return out;
}

std::vector<ExodusPart> partsOf(const BodyModel& body)
{
  std::vector<ExodusPart> parts;
  for (const BodyRegion& region : body.regions)
    parts.push_back({region.name.empty() ? body.name : body.name + ":" + region.name, {}});
  for (std::size_t c = 0; c < body.regionOfCell.size(); ++c)
    parts[std::size_t(body.regionOfCell[c])].cells.push_back(int(c));
  return parts;
}

void writeExodusFile(const Run& run, const std::vector<ExodusStep>& steps, const std::string& path,
                     const std::string& deckName)
{
  std::vector<ExodusBody> bodies;
  for (const auto& body : run.model.bodies)
    bodies.push_back({body.name, &body.mesh, &body.nodes, partsOf(body)});
  std::vector<ExodusContactSide> sides;
  for (const auto& interface : run.model.interfaces) {
    sides.push_back({interface.name + ":dirichlet", interface.dirichletBody, interface.dirichletFacets});
    sides.push_back({interface.name + ":neumann", interface.neumannBody, interface.neumannFacets});
  }
  writeExodus(path, run.summary.title, bodies, sides, steps, {"ndframe " + versionText(), "deck " + deckName});
}

std::string levelPath(const std::string& stem, int level)
{
  return fmt::format("{}.level-{:02}{}", stem, level, fieldsEnding);
}

/// The last state on the mesh of a level; the level stands for its time, so that ParaView plays the series.
void writeLevel(const Run& run, int level, const OutputOptions& output, const std::string& deckName, Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::WriteLevels);
  ExodusStep step = exodusStep(run, output, run.solved.states.size() - 1);
  step.time = level;
  ledger.count("bytes written", writeAtomically(levelPath(outputStem(output, deckName).string(), level),
                                                [&](const std::string& temporary) {
                                                  writeExodusFile(run, {step}, temporary, deckName);
                                                }));
}

/// Names the files of the levels; those that a longer run has left are removed.
void addLevelFiles(const AccuracySummary& accuracy, const std::string& stem, std::vector<std::string>& written)
{
  for (const auto& level : accuracy.levels)
    written.push_back(levelPath(stem, level.level));
  for (int left = int(accuracy.levels.size()) + 1; std::filesystem::exists(levelPath(stem, left)); ++left)
    removeEarlier(levelPath(stem, left));
}

/// What a run with a target leaves of its levels, whether the last one has a solution or not.
void writeLevels(const Run& run, const OutputOptions& output, const std::string& stem, Ledger& ledger,
                 std::vector<std::string>& written)
{
  if (output.allLevels)
    addLevelFiles(*run.summary.accuracy, stem, written);
  if (!run.plan.runs(Stage::LevelTable))
    return;
  const auto timer = timeStage(ledger, Stage::Write);
  written.push_back(stem + levelsEnding);
  ledger.count("bytes written", writeTextAtomically(written.back(), levelsCsv(run.summary.accuracy->levels)));
}

/// Writes the fields and the contact table that Output asks for; returns the files' names.
std::vector<std::string> writeSolution(const Run& run, const OutputOptions& output, const std::string& stem,
                                       const std::string& deckName, Ledger& ledger)
{
  std::vector<std::string> written;
  std::vector<ExodusStep> steps;
  if (run.plan.runs(Stage::Stress)) {
    const auto timer = timeStage(ledger, Stage::Stress);
    for (std::size_t s = 0; s < run.solved.states.size(); ++s)
      steps.push_back(exodusStep(run, output, s));
  }
  if (run.plan.runs(Stage::Write)) {
    const auto timer = timeStage(ledger, Stage::Write);
    if (run.plan.runs(Stage::Stress)) {
      written.push_back(stem + fieldsEnding);
      ledger.count("bytes written", writeAtomically(written.back(), [&](const std::string& temporary) {
                     writeExodusFile(run, steps, temporary, deckName);
                   }));
    }
    if (run.plan.runs(Stage::ContactTable)) {
      written.push_back(stem + contactEnding);
      ledger.count("bytes written",
                   writeTextAtomically(written.back(), contactCsv(sortedAlong(run.model.interfaces, run.solved.contact),
                                                                  run.model.bodies.front().mesh.dim)));
    }
    if (output.probeTable) {
      written.push_back(stem + probesEnding);
      ledger.count("bytes written", writeTextAtomically(written.back(), probesCsv(run.summary.probes,
                                                                                  run.model.bodies.front().mesh.dim)));
    }
  }
  return written;
}

/// An earlier run's solution must not stand beside the summary of a run that has none.
void removeSolution(const Plan& plan, const OutputOptions& output, const std::string& stem)
{
  if (output.probeTable)
    removeEarlier(stem + probesEnding);
  if (plan.runs(Stage::Stress))
    removeEarlier(stem + fieldsEnding);
  if (plan.runs(Stage::ContactTable))
    removeEarlier(stem + contactEnding);
}

/// The files that Output asks for, written on one rank; the summary comes after those whose cost it tells, the report
/// after the summary, of which it is made.
std::vector<std::string> writeFiles(Run& run, const OutputOptions& output, const std::string& deckName, Ledger& ledger)
{
  const std::string stem = outputStem(output, deckName).string();
  std::vector<std::string> written;
  if (run.summary.solved)
    written = writeSolution(run, output, stem, deckName, ledger);
  else
    removeSolution(run.plan, output, stem);
  if (run.summary.accuracy)
    writeLevels(run, output, stem, ledger, written);
  copyLedger(run.summary, ledger, run.startSeconds);
  if (output.summary) {
    written.push_back(stem + ".summary.json");
    writeTextAtomically(written.back(), toJson(run.summary));
  }
  if (output.report) {
    written.push_back(stem + ".report.html");
    writeReport(stem + ".summary.json");
  }
  return written;
}

} // namespace

LevelObserver levelWriter(const OutputOptions& output, const std::string& name, const Comm& comm, Ledger& ledger)
{
  if (!output.allLevels)
    return {};
  return
      [&](const Run& run, int level) { writeOnFirstRank(comm, [&] { writeLevel(run, level, output, name, ledger); }); };
}

std::vector<std::string> writeResults(Run& run, const OutputOptions& output, const std::string& name, const Comm& comm,
                                      Ledger& ledger)
{
  std::vector<std::string> written;
  writeOnFirstRank(comm, [&] { written = writeFiles(run, output, name, ledger); });
  return written;
}

} // namespace ndframe
