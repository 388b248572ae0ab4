#include "load_columns.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ndframe
{

double largestDisplacement(const RunSummary& summary)
{
  double value = 0.0;
  for (const auto& body : summary.bodies)
    value = std::max(value, body.displacement.value);
  return value;
}

double largestPressure(const RunSummary& summary)
{
  double value = 0.0;
  for (const auto& interface : summary.interfaces)
    value = std::max(value, interface.largestPressure);
  return value;
}

std::vector<std::string> forcePaths(const std::vector<StudyRow>& rows)
{
  const auto known =
      std::find_if(rows.begin(), rows.end(), [](const StudyRow& row) { return row.summary.has_value(); });
  std::vector<std::string> paths;
  if (known == rows.end())
    return paths;
  for (const auto& interface : known->summary->interfaces)
    paths.push_back(fmt::format("interfaces/{}/contact_force", interface.name));
  for (const auto& body : known->summary->bodies)
    for (const auto& support : body.supports)
      for (std::size_t k = 0; k < support.force.size(); ++k)
        paths.push_back(fmt::format("bodies/{}/supports/{}/force/{}", body.name, support.name, k));
  return paths;
}

} // namespace ndframe
