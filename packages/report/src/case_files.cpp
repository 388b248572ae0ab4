#include "ndframe/report/case_files.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/csv.hpp"
#include "ndframe/report/contact_table.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/report/summary_text.hpp"
#include "run_fields.hpp"
#include "scene_file.hpp"

namespace ndframe
{
namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The lines of a table with the name of the case before them; the head only for the first case.
std::string rowsOfCase(const std::string& table, const std::string& name, bool isFirst)
{
  std::string text;
  bool isHead = true;
  for (std::size_t begin = 0; begin < table.size(); isHead = false) {
    const std::size_t end = std::min(table.find('\n', begin), table.size() - 1) + 1;
    if (isFirst || !isHead)
      text += (isHead ? "case" : csvField(name)) + "," + table.substr(begin, end - begin);
    begin = end;
  }
  return text;
}

/// Energy and bound of the case beside what every step has.
void addNumbers(const RunSummary& summary, std::vector<NamedField>& global)
{
  global.push_back({"energy", {summary.energy}});
  if (!summary.errors || !summary.errors->global)
    return;
  global.push_back({"bound", {summary.errors->global->absolute}});
  global.push_back({"guaranteed", {summary.errors->guaranteed ? 1.0 : 0.0}});
}

using Fields = std::vector<NamedField>;

/// Where a step lacks fields that another one has, in the same order, they have this value.
void completeFields(Fields& fields, const Fields& all, double value)
{
  const std::size_t size = fields.empty() ? all.front().values.size() : fields.front().values.size();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i >= fields.size() || fields[i].name != all[i].name)
      fields.insert(fields.begin() + std::ptrdiff_t(i), {all[i].name, Vector(size, value)});
}

/// The same for the fields of every body or contact side.
void completeSteps(std::vector<ExodusStep>& steps, std::vector<Fields> ExodusStep::*fields, double value)
{
  if ((steps.front().*fields).empty())
    return;
  const auto numFields = [&](const ExodusStep& step) { return (step.*fields).front().size(); };
  const std::vector<Fields> all = *std::max_element(steps.begin(), steps.end(), [&](const auto& a, const auto& b) {
    return numFields(a) < numFields(b);
  }).*fields;
  for (ExodusStep& step : steps)
    for (std::size_t part = 0; part < all.size(); ++part)
      completeFields((step.*fields)[part], all[part], value);
}

/// All steps have the same variables: offsets are zero in a case without a Gap, and what a certificate would tell is no
/// number in a case without one.
void completeSteps(std::vector<ExodusStep>& steps)
{
  completeSteps(steps, &ExodusStep::nodal, 0.0);
  completeSteps(steps, &ExodusStep::element, unknown);
  completeSteps(steps, &ExodusStep::contactSide, unknown);
  const Fields all = std::max_element(steps.begin(), steps.end(), [](const auto& a, const auto& b) {
                       return a.global.size() < b.global.size();
                     })->global;
  for (ExodusStep& step : steps)
    completeFields(step.global, all, unknown);
}

/// A table, or nothing of an earlier run.
void writeTable(const std::string& path, const std::string& text, std::vector<std::string>& written)
{
  if (text.empty()) {
    removeEarlier(path);
    return;
  }
  writeTextAtomically(path, text);
  written.push_back(path);
}

} // namespace

CaseFiles::CaseFiles(OutputOptions output, std::string deckName, const Comm& comm)
    : output_(std::move(output)), deckName_(std::move(deckName)), comm_(comm)
{}

bool CaseFiles::keepsFields(const Run& run) const
{
  return output_.exodus && (comm_.rank() == 0 || isWrittenByAll(output_, exodusScene(run), comm_));
}

void CaseFiles::add(const Run& run, int number, const std::string& name)
{
  onEveryRank(comm_, [&] {
    if (keepsFields(run))
      addFields(run, number, name);
  });
  if (comm_.rank() != 0)
    return;
  const int dim = run.model.bodies.front().mesh.dim;
  if (output_.contactTable && !run.model.interfaces.empty())
    contact_ += rowsOfCase(contactCsv(run), name, contact_.empty());
  if (output_.probeTable)
    probes_ += rowsOfCase(probesCsv(run.summary.probes, dim), name, probes_.empty());
}

void CaseFiles::addFields(const Run& run, int number, const std::string& name)
{
  if (steps_.empty())
    keepMeshes(run);
  else if (!sameMeshes(run))
    throw InputError(fmt::format("the case \"{}\" has different meshes from the first one, so they cannot share a "
                                 "file; set Output/Exodus = false, or run it as a separate deck.",
                                 name));
  steps_.push_back(exodusStep(run, output_, run.solved.states.size() - 1));
  steps_.back().time = number;
  addNumbers(run.summary, steps_.back().global);
  names_.push_back(fmt::format("case {}: {}", number, name));
}

void CaseFiles::keepMeshes(const Run& run)
{
  ExodusScene scene = exodusScene(run);
  title_ = std::move(scene.title);
  bodies_ = std::move(scene.bodies);
  sides_ = std::move(scene.sides);
  shares_ = std::move(scene.shares);
  for (const ExodusBody& body : bodies_) {
    meshes_.push_back(*body.mesh);
    nodes_.push_back(*body.nodes);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b].mesh = &meshes_[b];
    bodies_[b].nodes = &nodes_[b];
  }
}

bool CaseFiles::sameMeshes(const Run& run) const
{
  const ExodusScene scene = exodusScene(run);
  bool same = scene.bodies.size() == bodies_.size() && scene.sides.size() == sides_.size();
  for (std::size_t b = 0; same && b < bodies_.size(); ++b)
    same = scene.bodies[b].nodes->points == nodes_[b].points && scene.bodies[b].nodes->cellNodes == nodes_[b].cellNodes;
  for (std::size_t s = 0; same && s < sides_.size(); ++s)
    same = scene.sides[s].body == sides_[s].body && scene.sides[s].facets.size() == sides_[s].facets.size();
  return same;
}

/// Rank 0 has the steps, and all have them where they write them.
std::vector<std::string> CaseFiles::writeFields(const std::string& stem, Ledger& ledger)
{
  const std::string path = stem + ".e";
  std::vector<std::string> written;
  std::vector<std::string> records = exodusRecords(deckName_);
  records.insert(records.end(), names_.begin(), names_.end());
  const ExodusScene scene{title_, bodies_, sides_, shares_};
  if (!steps_.empty())
    completeSteps(steps_);
  if (!steps_.empty() && isWrittenByAll(output_, scene, comm_))
    return writeByAll(path, output_, {scene, steps_, records}, comm_, ledger);
  writeOnFirstRank(comm_, [&] {
    if (!steps_.empty())
      written = writeWhole(path, {scene, steps_, records}, ledger);
    else if (output_.exodus)
      removeScene(path);
  });
  return written;
}

std::vector<std::string> CaseFiles::write(Ledger& ledger)
{
  const std::string stem = commonStem(output_, deckName_, comm_);
  std::vector<std::string> written = writeFields(stem, ledger);
  writeOnFirstRank(comm_, [&] {
    if (output_.contactTable)
      writeTable(stem + ".contact.csv", contact_, written);
    if (output_.probeTable)
      writeTable(stem + ".probes.csv", probes_, written);
  });
  return written;
}

} // namespace ndframe
