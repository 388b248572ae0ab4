#pragma once

#include <memory>
#include <string>

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe::test
{

/// A recovery as the deck names it, with its parameters; all are integers but "Least Gain".
std::unique_ptr<StressRecovery> makeRecovery(const std::string& type,
                                             const std::vector<std::pair<std::string, double>>& entries = {});
/// "Global" with so many steps, whatever they gain.
std::unique_ptr<StressRecovery> withSteps(int degree, int steps);

/// What a recovery gives on all ranks of test::comm(), with the corrections of all cells.
std::vector<SceneStress> recoverWhole(const StressRecovery& recovery, const RecoveryScene& scene,
                                      const std::vector<SceneField>& fields, Ledger& ledger);

} // namespace ndframe::test
