#pragma once

#include "ndframe/base/log.hpp"
#include "ndframe/run/run_observer.hpp"

namespace ndframe
{

/// Tells the screen. The log must live as long.
class ScreenObserver final : public RunObserver
{
public:
  explicit ScreenObserver(const Log& log) : log_(log) {} ///< not owned

  void header(const RunSummary& outline, const Model& model, bool rolesAreKnown) override;
  void factor(const std::string& body, const std::string& description) override;
  void roles(const std::vector<RoleSummary>& parts) override;
  void sweeps(const Model& model) override;
  void sweep(const SweepRecord& record) override;
  void stopped(const CouplingResult& result) override;
  void gaveUp(const std::string& reason) override;
  void levels(const AccuracySummary& summary, bool replacesTolerance) override;
  void level(const LevelSummary& level, const std::string& note) override;

private:
  const Log& log_;
};

} // namespace ndframe
