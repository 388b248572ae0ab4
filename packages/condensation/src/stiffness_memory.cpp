#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{

void giveBackStiffness(CondensedModel& condensed)
{
  for (std::size_t b = 0; b < condensed.systems.size(); ++b) {
    const auto* const whole = wholeSolver(*condensed.condensed[b]);
    const BodyTrace* const trace = condensed.trace(int(b));
    if (whole == nullptr || (trace != nullptr && !trace->isSolvedWhole()))
      continue;
    whole->forget();
    giveBackStiffness(condensed.systems[b]);
  }
}

void assembleAgain(CondensedModel& condensed, const Model& model, Ledger& ledger)
{
  for (std::size_t b = 0; b < condensed.systems.size(); ++b)
    if (condensed.systems[b].K.values.empty()) {
      const auto timer = timeStage(ledger, Stage::Assemble);
      assembleAgain(condensed.systems[b], model.bodies[b]);
    }
}

} // namespace ndframe
