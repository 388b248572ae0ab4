#pragma once

#include <memory>
#include <vector>

#include "ndframe/driver/model.hpp"
#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{

class Log;

/// The scene assembled, factored and condensed to the interfaces: what every sweep, tolerance and load case works on.
struct CondensedModel
{
  std::vector<BodySystem> systems;
  std::vector<Vector> loads; ///< effective loads, per body
  std::vector<std::unique_ptr<CondensedBody>> condensed;
  InterfaceSystem interface; ///< no unknowns without interfaces

  /// The trace of a body, null if it touches nothing.
  const BodyTrace* trace(int body) const;
};

/// One factorisation per body, whatever follows.
CondensedModel condense(const Model& model, const LinearSolver& solver, const InterfaceOperator& representation,
                        const Comm& comm, Ledger& ledger, const Log& log);

/// Takes the model's loads anew (a second load case): no factorisation, one reduction per touching body.
void reloadCondensed(CondensedModel& condensed, const Model& model, const Comm& comm);

} // namespace ndframe
