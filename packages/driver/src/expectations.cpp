#include <cmath>

#include <fmt/format.h>

#include "summarize.hpp"

namespace ndframe
{
namespace
{

/// Counts and seconds appear in the ledger only when something happened: absent means zero.
bool isLedgerPath(const std::string& path)
{
  return path.rfind("ledger/", 0) == 0;
}

} // namespace

void checkExpectationNames(const RunSummary& outline, const Params& deck, Diagnostics& diagnostics)
{
  for (const auto& expectation : deck.sub("Expect").subs()) {
    const auto quantity = expectation.get<std::string>("Quantity");
    if (!isLedgerPath(quantity) && !summaryValue(outline, quantity))
      diagnostics.add(expectation.mistake(
          "Quantity",
          fmt::format("\"{}\" is no number of this run's summary; examples are \"energy\", \"bodies/{}/energy\", "
                      "\"residuals/equilibrium\".",
                      quantity, outline.bodies.front().name)));
  }
}

void checkExpectations(RunSummary& summary, const Params& deck)
{
  for (const auto& expectation : deck.sub("Expect").subs()) {
    ExpectationSummary result;
    result.name = expectation.name();
    result.value = summaryValue(summary, expectation.get<std::string>("Quantity")).value_or(0.0);
    result.expected = expectation.get<double>("Value");
    result.tolerance = expectation.get<double>("Tolerance");
    result.met = std::abs(result.value - result.expected) <= result.tolerance;
    summary.expectations.push_back(std::move(result));
  }
}

} // namespace ndframe
