#include "sample_recovery.hpp"

#include <fmt/format.h>

#include "common/test_main.hpp"
#include "ndframe/recovery/scene_pieces.hpp"

namespace ndframe::test
{

std::unique_ptr<StressRecovery> makeRecovery(const std::string& type,
                                             const std::vector<std::pair<std::string, double>>& entries)
{
  Registry<StressRecovery> registry("recovery", "Star");
  registerRecoveries(registry);
  ListSpec spec;
  spec.choices = registry.choices();
  std::string xml =
      fmt::format(R"(<ParameterList name="Recovery"><Parameter name="Type" type="string" value="{}"/>)", type);
  for (const auto& [key, value] : entries)
    xml += fmt::format(R"(<Parameter name="{}" type="{}" value="{}"/>)", key, key == "Least Gain" ? "double" : "int",
                       value);
  Diagnostics diagnostics;
  const Params params = validate(parseDeck(xml + "</ParameterList>", "recovery.xml"), spec, diagnostics);
  diagnostics.throwIfAny();
  return registry.build(params);
}

std::unique_ptr<StressRecovery> withSteps(int degree, int steps)
{
  return makeRecovery("Global", {{"Degree", degree}, {"Least Gain", 0.0}, {"Steps", steps}});
}

std::vector<SceneStress> recoverWhole(const StressRecovery& recovery, const RecoveryScene& scene,
                                      const std::vector<SceneField>& fields, Ledger& ledger)
{
  std::vector<SceneStress> stresses = recovery.recover(scene, fields, comm(), ledger);
  for (SceneStress& stress : stresses)
    if (stress.pieces) {
      gatherPieces(*stress.pieces, stress.corrections, comm());
      stress.pieces.reset();
    }
  return stresses;
}

} // namespace ndframe::test
