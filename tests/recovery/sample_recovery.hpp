#pragma once

#include <memory>
#include <string>

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe::test
{

/// A recovery as the deck names it: type "Star" or "Element", with its integer parameters.
std::unique_ptr<StressRecovery> makeRecovery(const std::string& type,
                                             const std::vector<std::pair<std::string, int>>& entries = {});

/// What a recovery gives on all ranks of test::comm(), with the corrections of all cells.
std::vector<SceneStress> recoverWhole(const StressRecovery& recovery, const RecoveryScene& scene,
                                      const std::vector<SceneField>& fields, Ledger& ledger);

} // namespace ndframe::test
