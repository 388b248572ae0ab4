#include "study_table.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "load_columns.hpp"
#include "ndframe/io/csv.hpp"
#include "ndframe/report/summary_text.hpp"
#include "ndframe/scene/recipe.hpp"

namespace ndframe
{
namespace
{

using Number = std::function<std::optional<double>(const StudyRow&)>;

/// A column of the table and of the screen.
struct Column
{
  std::string name;
  Number number;
};

Number ofSummary(const std::string& path)
{
  return [path](const StudyRow& row) { return row.summary ? summaryValue(*row.summary, path) : std::nullopt; };
}

std::int64_t counted(const StudyRow& row, const std::string& what)
{
  if (!row.summary)
    return 0;
  const auto found = row.summary->counts.find(what);
  return found == row.summary->counts.end() ? 0 : found->second;
}

Number count(const std::string& what)
{
  return [what](const StudyRow& row) { return std::optional(double(counted(row, what))); };
}

std::optional<double> dofs(const StudyRow& row)
{
  if (!row.summary)
    return std::nullopt;
  double sum = 0.0;
  for (const auto& body : row.summary->bodies)
    sum += double(body.dofs);
  return sum;
}

std::optional<double> lastEpsilon(const StudyRow& row)
{
  if (!row.summary || !row.summary->coupling || row.summary->coupling->history.empty())
    return std::nullopt;
  return row.summary->coupling->history.back().epsTau;
}

/// Of this case: the stages' marks are reset at their beginning, the run's is not.
std::optional<double> peakBytes(const StudyRow& row)
{
  if (!row.summary)
    return std::nullopt;
  std::int64_t peak = 0;
  for (const auto& stage : row.summary->stages)
    peak = std::max(peak, stage.peakBytes);
  return double(peak);
}

const std::vector<Column>& everyTimeColumns()
{
  static const std::vector<Column> columns{
      {"dofs", dofs},
      {"energy", ofSummary("energy")},
      {"sweeps", ofSummary("coupling/sweeps")},
      {"eps_tau", lastEpsilon},
      {"converged", ofSummary("coupling/converged")},
      {"bound", ofSummary("errors/global/absolute")},
      {"bound_relative", ofSummary("errors/global/relative")},
      {"guaranteed", ofSummary("errors/global/guaranteed")},
      {"mesh_part", ofSummary("errors/discretization/absolute")},
      {"iteration_part", ofSummary("errors/algorithm/absolute")},
      {"reference_error", ofSummary("errors/reference/displacement")},
      {"effectivity", ofSummary("errors/reference/effectivity")},
      {"exit_code", [](const StudyRow& row) { return std::optional(double(row.code)); }},
      {"seconds", [](const StudyRow& row) { return std::optional(row.seconds); }},
      {"factorisations", count("factorisations")},
      {"factors_reused", count("factors reused")},
      {"meshes_reused", count("meshes reused")},
      {"references_reused", count("references reused")},
      {"back_solves", count("back-solves")},
      {"peak_bytes", peakBytes}};
  return columns;
}

Number largest(double (*of)(const RunSummary&))
{
  return [of](const StudyRow& row) {
    return row.summary && row.summary->solved ? std::optional(of(*row.summary)) : std::nullopt;
  };
}

std::vector<Column> columnsOf(const Study& study, const std::vector<StudyRow>& rows)
{
  std::vector<Column> columns = everyTimeColumns();
  if (study.loads) {
    columns.push_back({"largest_displacement", largest(largestDisplacement)});
    columns.push_back({"largest_pressure", largest(largestPressure)});
    for (const auto& path : forcePaths(rows))
      columns.push_back({path, ofSummary(path)});
  }
  for (const auto& path : study.columns)
    columns.push_back({path, ofSummary(path)});
  return columns;
}

std::string csvLine(std::vector<std::string> fields)
{
  std::transform(fields.begin(), fields.end(), fields.begin(), csvField);
  return fmt::format("{}\n", fmt::join(fields, ","));
}

/// What the screen shows of a case besides its values.
struct ScreenColumn
{
  const char* name;
  int width;
  const char* format; ///< of a double
  Number number;
};

const std::vector<ScreenColumn>& screenColumns(const Study& study)
{
  static const std::vector<ScreenColumn> ofLoads{{"energy", 15, "{:.7g}", ofSummary("energy")},
                                                 {"displacement", 14, "{:.4g}", largest(largestDisplacement)},
                                                 {"pressure", 11, "{:.4g}", largest(largestPressure)},
                                                 {"sweeps", 7, "{:.0f}", ofSummary("coupling/sweeps")},
                                                 {"bound", 11, "{:.4g}", ofSummary("errors/global/absolute")},
                                                 {"guaranteed", 11, "{:.0f}", ofSummary("errors/global/guaranteed")},
                                                 {"factored", 9, "{:.0f}", count("factorisations")},
                                                 {"reused", 7, "{:.0f}", count("factors reused")}};
  static const std::vector<ScreenColumn> columns{{"dofs", 9, "{:.0f}", dofs},
                                                 {"energy", 13, "{:.7g}", ofSummary("energy")},
                                                 {"sweeps", 7, "{:.0f}", ofSummary("coupling/sweeps")},
                                                 {"bound", 10, "{:.4g}", ofSummary("errors/global/absolute")},
                                                 {"factored", 9, "{:.0f}", count("factorisations")},
                                                 {"reused", 7, "{:.0f}", count("factors reused")}};
  return study.loads ? ofLoads : columns;
}

/// The last name of the path that the axis is called by, or is.
std::string shortName(const StudyAxis& axis)
{
  return axis.name.substr(axis.name.rfind('/') + 1);
}

/// Wide enough for the name and every value of the axis' first parameter, which stands for the others.
std::size_t widthOf(const StudyAxis& axis)
{
  std::size_t width = shortName(axis).size();
  for (const auto& value : axis.values.front())
    width = std::max(width, value.size());
  return width + 2;
}

/// "matrix and factor of punch; supports and loads of foundation": what the second of two cases computes again.
std::string whatChanges(const SceneRecipe& before, const SceneRecipe& now)
{
  const bool sameBodies = before.bodies.size() == now.bodies.size();
  std::vector<std::string> changes;
  for (std::size_t b = 0; b < now.bodies.size(); ++b) {
    const BodyRecipe old = sameBodies ? before.bodies[b] : BodyRecipe{}, &body = now.bodies[b];
    if (body.mesh != old.mesh)
      changes.push_back(fmt::format("mesh, matrix and factor of {}", body.name));
    else if (body.matrix != old.matrix || before.solver != now.solver)
      changes.push_back(fmt::format("matrix and factor of {}", body.name));
    else if (body.load != old.load)
      changes.push_back(fmt::format("supports and loads of {} (the factor too if other nodes are held)", body.name));
  }
  if (before.interfaces != now.interfaces)
    changes.emplace_back("the interfaces (factors too if other nodes touch)");
  if (before.representation != now.representation)
    changes.emplace_back("the interface operators");
  return changes.empty() ? "the solution only: nothing read, assembled or factored"
                         : fmt::format("{}", fmt::join(changes, "; "));
}

} // namespace

std::string studyCsv(const Study& study, const std::vector<StudyRow>& rows)
{
  const auto columns = columnsOf(study, rows);
  std::vector<std::string> names{"case"};
  for (const auto& axis : study.axes)
    for (const auto& parameter : axis.parameters)
      names.push_back(parameter.path);
  for (const auto& column : columns)
    names.push_back(column.name);
  names.emplace_back("reason");
  std::string text = csvLine(std::move(names));
  for (const auto& row : rows) {
    std::vector<std::string> fields{fmt::format("{}", row.number)};
    fields.insert(fields.end(), row.values.begin(), row.values.end());
    for (const auto& column : columns) {
      const auto number = column.number(row);
      fields.push_back(number ? fmt::format("{}", *number) : std::string());
    }
    fields.push_back(row.reason);
    text += csvLine(std::move(fields));
  }
  return text;
}

std::string studyTitle(const Study& study)
{
  std::string line = "  case";
  for (const auto& axis : study.axes)
    line += fmt::format("{:>{}}", shortName(axis), widthOf(axis));
  for (const auto& column : screenColumns(study))
    line += fmt::format("{:>{}}", column.name, column.width);
  return line + "   seconds";
}

std::string studyLine(const Study& study, const StudyRow& row)
{
  std::string line = fmt::format("{:>6}", row.number);
  std::size_t value = 0;
  for (const auto& axis : study.axes) {
    line += fmt::format("{:>{}}", row.values[value], widthOf(axis));
    value += axis.parameters.size();
  }
  for (const auto& column : screenColumns(study)) {
    const auto number = column.number(row);
    line += fmt::format("{:>{}}", number ? fmt::format(fmt::runtime(column.format), *number) : "-", column.width);
  }
  return line + fmt::format("{:>10.2f}", row.seconds);
}

std::string studyPlan(const Study& study)
{
  std::string text =
      fmt::format("  {} case{}: the first runs these stages, later ones reuse; a step along an axis recomputes\n",
                  study.cases.size(), study.cases.size() == 1 ? "" : "s");
  std::size_t stride = study.cases.size();
  for (const auto& axis : study.axes) {
    stride /= axis.size();
    const auto changes = axis.size() == 1 ? "nothing: it has one value"
                                          : whatChanges(recipeOf(readScene(study.cases[stride - 1].deck)),
                                                        recipeOf(readScene(study.cases[stride].deck)));
    text += fmt::format("  {:<19} {}\n", shortName(axis), changes);
  }
  text += fmt::format("  {:<19} {}{}.csv, one row per case{}", "table", study.fileName, study.tableEnding(),
                      study.writesFiles ? "; and the files of every case" : "");
  return text + (study.loads && study.loads->sharesFiles ? "; the other files hold all cases" : "");
}

std::string studyTotal(const std::vector<StudyRow>& rows)
{
  std::int64_t factored = 0, reused = 0, meshes = 0;
  for (const auto& row : rows) {
    factored += counted(row, "factorisations");
    reused += counted(row, "factors reused");
    meshes += counted(row, "meshes reused");
  }
  return fmt::format("{} case{}: {} factorisation{}; {} factors and {} meshes reused", rows.size(),
                     rows.size() == 1 ? "" : "s", factored, factored == 1 ? "" : "s", reused, meshes);
}

} // namespace ndframe
