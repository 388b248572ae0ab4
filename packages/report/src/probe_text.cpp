#include "ndframe/report/summary_text.hpp"

#include <iterator>

#include <fmt/format.h>

#include "ndframe/io/csv.hpp"
#include "summary_json.hpp"

namespace ndframe
{
namespace
{

constexpr std::array axes{"x", "y", "z"};
constexpr std::array components{"xx", "yy", "zz", "xy", "yz", "zx"}; ///< the first four in the plane

std::size_t numComponents(std::size_t dim)
{
  return dim == 2 ? 4 : components.size();
}

Json orNull(const std::optional<double>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json pointJson(const PointSummary& point)
{
  auto stress = Json::object();
  for (std::size_t i = 0; i < numComponents(point.point.size()); ++i)
    stress[components.at(i)] = point.stress.at(i);
  return {{"point", point.point},
          {"displacement", point.displacement},
          {"stress", std::move(stress)},
          {"von_mises", point.vonMises},
          {"contact_pressure", orNull(point.contactPressure)},
          {"contact_gap", orNull(point.contactGap)}};
}

Json probeJson(const ProbeSummary& probe)
{
  Json json{{"name", probe.name}, {"body", probe.body}};
  if (probe.side)
    json.update({{"side", probe.side->side},
                 {"measure", probe.side->measure},
                 {"displacement", probe.side->displacement},
                 {"force", probe.side->force},
                 {"moment", probe.side->moment},
                 {"about", probe.side->about}});
  else if (!probe.isLine)
    json.update(pointJson(probe.points.front()));
  else
    for (const PointSummary& point : probe.points)
      json["points"].push_back(pointJson(point));
  return json;
}

/// A row of the table: fields in the order of the columns.
class Row
{
public:
  explicit Row(std::string& text) : text_(text) {}
  ~Row() { text_ += '\n'; }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  void add(const std::string& field)
  {
    text_ += (isFirst_ ? "" : ",") + field;
    isFirst_ = false;
  }
  void add(double value) { add(fmt::format("{:.17g}", value)); }
  void add(const std::optional<double>& value) { value ? add(*value) : add(std::string()); }
  void add(const std::vector<double>& values)
  {
    for (const double value : values)
      add(value);
  }
  void skip(std::size_t fields)
  {
    for (std::size_t i = 0; i < fields; ++i)
      add(std::string());
  }

private:
  std::string& text_;
  bool isFirst_ = true;
};

void addTitle(std::string& text, std::size_t dim)
{
  Row row(text);
  for (const char* name : {"probe", "body", "side", "point"})
    row.add(std::string(name));
  const auto vector = [&](const std::string& prefix) {
    for (std::size_t k = 0; k < dim; ++k)
      row.add(prefix + axes.at(k));
  };
  vector("");
  vector("u_");
  for (std::size_t i = 0; i < numComponents(dim); ++i)
    row.add(std::string("stress_") + components.at(i));
  for (const char* name : {"von_mises", "contact_pressure", "contact_gap", "measure"})
    row.add(std::string(name));
  vector("force_");
  if (dim == 2)
    row.add(std::string("moment"));
  else
    vector("moment_");
}

std::size_t numMoments(std::size_t dim)
{
  return dim == 2 ? 1 : dim;
}

void addPoint(std::string& text, const ProbeSummary& probe, std::size_t number, std::size_t dim)
{
  const PointSummary& point = probe.points[number];
  Row row(text);
  row.add(csvField(probe.name));
  row.add(csvField(probe.body));
  row.skip(1);
  row.add(fmt::format("{}", number));
  row.add(point.point);
  row.add(point.displacement);
  for (std::size_t i = 0; i < numComponents(dim); ++i)
    row.add(point.stress.at(i));
  row.add(point.vonMises);
  row.add(point.contactPressure);
  row.add(point.contactGap);
  row.skip(1 + dim + numMoments(dim));
}

void addSide(std::string& text, const ProbeSummary& probe, std::size_t dim)
{
  Row row(text);
  row.add(csvField(probe.name));
  row.add(csvField(probe.body));
  row.add(csvField(probe.side->side));
  row.skip(1);
  row.add(probe.side->about);
  row.add(probe.side->displacement);
  row.skip(numComponents(dim) + 3);
  row.add(probe.side->measure);
  row.add(probe.side->force);
  row.add(probe.side->moment);
}

} // namespace

Json probesJson(const std::vector<ProbeSummary>& probes)
{
  auto array = Json::array();
  for (const ProbeSummary& probe : probes)
    array.push_back(probeJson(probe));
  return array;
}

std::string probesCsv(const std::vector<ProbeSummary>& probes, int dim)
{
  std::string text;
  const auto size = std::size_t(dim);
  addTitle(text, size);
  for (const ProbeSummary& probe : probes) {
    for (std::size_t number = 0; number < probe.points.size(); ++number)
      addPoint(text, probe, number, size);
    if (probe.side)
      addSide(text, probe, size);
  }
  return text;
}

} // namespace ndframe
