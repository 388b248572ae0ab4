#include "ndframe/report/cases_summary.hpp"

#include "summary_json.hpp"

namespace ndframe
{
namespace
{

Json caseJson(const CaseSummary& given)
{
  auto factors = Json::object();
  for (const auto& [path, factor] : given.factors)
    factors[path] = factor;
  return {{"name", given.name},          {"factors", std::move(factors)},
          {"exit_code", given.exitCode}, {"reason", given.reason},
          {"seconds", given.seconds},    {"results", given.results ? summaryJson(*given.results) : Json(nullptr)}};
}

} // namespace

std::string toJson(const CasesSummary& summary)
{
  auto cases = Json::array();
  for (const auto& given : summary.cases)
    cases.push_back(caseJson(given));
  const Json json{{"version", summary.version},
                  {"title", summary.title},
                  {"deck", Json::parse(summary.deckJson)},
                  {"cases", std::move(cases)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace ndframe
