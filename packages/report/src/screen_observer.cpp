#include "ndframe/report/screen_observer.hpp"

#include <fmt/format.h>

#include "ndframe/report/accuracy_screen.hpp"
#include "ndframe/report/screen.hpp"

namespace ndframe
{

void ScreenObserver::header(const RunSummary& outline, const Model& model, bool rolesAreKnown)
{
  log_.line(headerText(outline, model, rolesAreKnown));
}

void ScreenObserver::factor(const std::string& body, const std::string& description)
{
  log_.detail(fmt::format("  {}: {}", body, description));
}

void ScreenObserver::roles(const std::vector<RoleSummary>& parts)
{
  log_.line(rolesText(parts));
}

void ScreenObserver::sweeps(const Model& model)
{
  log_.line("\n" + sweepTitle(model.interfaces.front(), model));
}

void ScreenObserver::sweep(const SweepRecord& record)
{
  log_.line(sweepLine(record));
}

void ScreenObserver::stopped(const CouplingResult& result)
{
  log_.line(fmt::format("  {}: {}", result.converged ? "stopped" : "NOT CONVERGED", result.reason));
}

void ScreenObserver::gaveUp(const std::string& reason)
{
  log_.line("  NOT CONVERGED: " + reason);
}

void ScreenObserver::levels(const AccuracySummary& summary, bool replacesTolerance)
{
  log_.line("\n" + levelTitle(summary, replacesTolerance));
}

void ScreenObserver::level(const LevelSummary& level, const std::string& note)
{
  log_.line(levelLine(level, note));
}

} // namespace ndframe
