#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "ndframe/certification/certificate_components.hpp"
#include "ndframe/certification/error_options.hpp"
#include "ndframe/certification/error_summary.hpp"
#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/condensation/solution.hpp"
#include "ndframe/estimation/energy_bracket.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

class ReferenceSolution;

/// What Error Estimation computed: numbers for the summary, fields for the Exodus file.
struct Certificate
{
  ErrorSummary summary;                ///< without the energy's bracket
  std::optional<EnergyBracket> energy; ///< with a guaranteed bound, but see docs/theory.md, section 8
  /// Contributions of the elements (42), not squared, per body and cell; empty when not asked for.
  std::vector<CellValues> etaGlobal, etaDiscretization, /**< of the mesh, (55) */ etaAlgorithm; ///< of the sweeps, (50)
  std::vector<ContactPatch> patches; ///< of all interfaces, in the order of their InterfaceMesh facets
  ContactTraction traction;          ///< the admissible traction t^ of the global measure; empty shares without contact
  std::vector<NodalField> intermediate;        ///< u~ per body, global axes; empty when not recovered
  std::vector<NodalField> admissible;          ///< u^ per body, global axes; empty when not recovered
  std::vector<StressCorrection> corrections;   ///< of the global stress, per body: as SceneStress
  std::shared_ptr<const ScenePieces> pieces{}; ///< of them, where cells are shared by the ranks

  /// All ranks get the corrections of all cells, 0.7 kB a cell of order 2: for files that show them. Collective.
  void gatherStress(const Comm& comm);
  void forgetStress(); ///< gives back the memory of corrections that nobody will ask for
};

/// Section 5: everything that the options (the deck's Error Estimation, or less) ask for, for the final state of a run.
/// Collective.
/// `fields`: the final state is their last. `reference`: of an earlier run or null; kept where it suits, else replaced.
/// onFields: called when no matrix of the scene will be read any more; what it gives back, recovery and estimators
/// have. Throws NotConverged when no admissible traction exists.
Certificate certify(
    const SceneSettings& settings, const ErrorOptions& options, const CertificateComponents& components,
    const Model& model, const CondensedModel& condensed, const CouplingResult& coupling,
    const std::vector<BodyFields>& fields, const Comm& comm, Ledger& ledger,
    std::shared_ptr<const ReferenceSolution>& reference, const std::function<void()>& onFields = [] {});

} // namespace ndframe
