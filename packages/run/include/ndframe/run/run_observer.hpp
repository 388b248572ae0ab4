#pragma once

#include <string>
#include <vector>

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/run/run_summary.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// What a run tells while it works; its steps print nothing. This one takes no notice.
class RunObserver
{
public:
  virtual ~RunObserver() = default;
  /// The scene is read and checked; outline: names and sizes. rolesAreKnown: they are as the deck gives them.
  virtual void header(const RunSummary& /*outline*/, const Model& /*model*/, bool /*rolesAreKnown*/) {}
  /// A body is factored.
  virtual void factor(const std::string& /*body*/, const std::string& /*description*/) {}
  virtual void roles(const std::vector<RoleSummary>& /*parts*/) {} ///< they are chosen; one a connected part
  /// Before the first sweep.
  virtual void sweeps(const Model& /*model*/) {}
  virtual void sweep(const SweepRecord& /*record*/) {} ///< a sweep is done
  /// After the last one.
  virtual void stopped(const CouplingResult& /*result*/) {}
  /// There is no solution.
  virtual void gaveUp(const std::string& /*reason*/) {}
  /// Before the first level. replacesTolerance: the sweeps end by the balance with the mesh although the deck names a
  /// tolerance.
  virtual void levels(const AccuracySummary& /*summary*/, bool /*replacesTolerance*/) {}
  /// A level is solved and certified. note: on its meshes, may be empty.
  virtual void level(const LevelSummary& /*level*/, const std::string& /*note*/) {}
};

} // namespace ndframe
