#include "ndframe/certification/certificate.hpp"

#include <algorithm>
#include <cmath>

#include "coarse_tractions.hpp"
#include "element_distances.hpp"
#include "interface_misfit.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/certification/advice.hpp"
#include "ndframe/estimation/residual.hpp"
#include "ndframe/estimation/zienkiewicz_zhu.hpp"
#include "ndframe/scene/stage.hpp"
#include "nearest_traction.hpp"
#include "point_caveat.hpp"
#include "reference_solution.hpp"

namespace ndframe
{
namespace
{

/// Section 5 as the deck asks for it: each step is one function, run() is their order.
class Certifier
{
public:
  Certifier(const SceneSettings& settings, const ErrorOptions& options, const CertifiedScene& scene,
            const StressRecovery& recovery, const Comm& comm, Ledger& ledger)
      : settings_(settings), options_(options), scene_(scene), recovery_(recovery), comm_(comm), ledger_(ledger)
  {}

  Certificate run(const CertificateComponents& components, std::shared_ptr<const ReferenceSolution>& reference,
                  const std::function<void()>& onFields)
  {
    if (options_.needsTraction()) {
      admitTractions();
      solveIntermediateFields();
    }
    onFields();
    if (options_.recoversStress())
      recoverStresses();
    if (options_.checkEquilibrium)
      checkStresses();
    measure();
    if (wants(Estimator::Reference))
      compare(components, reference);
    return std::move(result_);
  }

private:
  bool wants(Estimator estimator) const { return options_.wants(estimator); }
  void admitTractions();
  IntermediateField nearestField(const InterfaceValues& traction, TractionSign sign);
  void solveIntermediateFields();
  void recoverStresses();
  void checkStresses();
  void measure();
  ErrorMeasure measureStressOf(const RecoveredField& field);
  void measureGlobal();
  void compareWithIndicators();
  void compare(const CertificateComponents& components, std::shared_ptr<const ReferenceSolution>& reference);
  SceneField globalField() const;

  const SceneSettings& settings_;
  const ErrorOptions& options_;
  const CertifiedScene& scene_;
  const StressRecovery& recovery_;
  const Comm& comm_;
  Ledger& ledger_;
  RecoveredField global_, separate_; ///< of (40); of the two separate problems of (55)
  RecoveryScene recoveryScene_;
  AdmissibleScene admissible_;
  ErrorMeasure globalMeasure_;
  Certificate result_;
};

void Certifier::admitTractions()
{
  const auto timer = timeStage(ledger_, Stage::CertifyTraction);
  const InterfaceState& state = scene_.coupling.state;
  const bool asPublished = options_.mode == ErrorMode::Paper;
  const TractionSign sign = asPublished ? TractionSign::Values : TractionSign::Coefficients;
  if (options_.needsGlobalField()) {
    const bool updated = options_.tractionMean == TractionMean::Updated;
    global_.field = nearestField(meanTraction(scene_.coupling, updated),
                                 options_.optimises(recovery_, scene_.dim()) ? TractionSign::Coefficients : sign);
  }
  if (!wants(Estimator::Discretization))
    return;
  IntermediateField& sides = separate_.field;
  sides.tractions[0] = admitTraction(scene_, state.tractionDirichlet, sign);
  sides.tractions[1] = state.tractionDirichlet == state.tractionNeumann
                           ? sides.tractions[0]
                           : tractionFromNodes(scene_.patches, state.tractionNeumann, scene_.order, scene_.degree);
}

/// The admissible traction, of those that may stand for the computed one, that changes the solution least and that its
/// stress carries best, about; and its field, unless there is nothing to choose.
IntermediateField Certifier::nearestField(const InterfaceValues& traction, TractionSign sign)
{
  std::vector<IntermediateField> fields;
  std::vector<IntermediateField*> wanted;
  const Vector cost = options_.mode == ErrorMode::Paper ? Vector() : openingCost(scene_, traction);
  const std::vector<Vector> candidates = tractionsOfSides(scene_, traction);
  std::vector<Vector> admitted;
  for (const Vector& candidate : candidates) {
    admitted.push_back(admitNodal(scene_, candidate, sign, cost));
    fields.push_back(fieldOf(scene_, admitted.back()));
  }
  for (std::size_t f = 0; f < fields.size() && fields.size() > 1; ++f)
    wanted.push_back(&fields[f]);
  if (!wanted.empty())
    solveFields(scene_, wanted);
  Vector costs;
  for (const IntermediateField* field : wanted)
    costs.push_back(std::hypot(changeInEnergy(scene_.bodies, scene_.solved, field->displacement, scene_.parts),
                               interfaceMisfit(scene_, *field)));
  const auto best = std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
  const bool moves = scene_.dim() == 2 && options_.mode == ErrorMode::Strict &&
                     options_.tractionWith(recovery_, 2) == TractionType::Optimal;
  return moves
             ? nearestInEnergy(scene_, candidates[best], admitted[best], std::move(fields[best]), {sign, cost}, ledger_)
             : std::move(fields[best]);
}

void Certifier::solveIntermediateFields()
{
  const auto timer = timeStage(ledger_, Stage::CertifyFields);
  std::vector<IntermediateField*> fields;
  if (options_.needsGlobalField() && global_.field.displacement.empty())
    fields.push_back(&global_.field);
  if (wants(Estimator::Discretization))
    fields.push_back(&separate_.field);
  solveFields(scene_, fields, recovery_.settles(scene_.dim()) && !measuresFields(options_) && areOfOneSize(scene_));
}

SceneField Certifier::globalField() const
{
  SceneField field = makeSceneField(global_.field);
  field.enough = options_.enough.square(scene_.norm);
  if (field.optimise = options_.optimises(recovery_, scene_.dim()); field.optimise)
    setOpening(scene_, global_.field, admissible_, field);
  return field;
}

void Certifier::recoverStresses()
{
  const auto timer = timeStage(ledger_, Stage::CertifyRecovery);
  if (scene_.patches.empty())
    global_.field.displacement = scene_.solved;
  recoveryScene_ = makeRecoveryScene(scene_);
  admissible_ = admitScene(scene_, recoveryScene_, options_.mode);
  std::vector<RecoveredField*> wanted;
  std::vector<SceneField> fields;
  if (options_.recoversGlobalStress()) {
    wanted.push_back(&global_);
    fields.push_back(globalField());
  }
  if (wants(Estimator::Discretization)) {
    wanted.push_back(&separate_);
    fields.push_back(makeSceneField(separate_.field));
  }
  auto stresses = recovery_.recover(recoveryScene_, fields, comm_, ledger_);
  for (std::size_t f = 0; f < wanted.size(); ++f)
    wanted[f]->stress = std::move(stresses[f]);
  settle(scene_, recoveryScene_, wanted, ledger_);
}

void Certifier::checkStresses()
{
  const auto timer = timeStage(ledger_, Stage::CertifyEquilibrium);
  const auto defectOf = [&](const RecoveredField& recovered) -> std::optional<double> {
    const bool isThere = !recovered.stress.corrections.empty();
    return isThere ? std::optional(equilibriumDefect(scene_, recoveryScene_, recovered)) : std::nullopt;
  };
  result_.summary.equilibrium = defectOf(global_);
  result_.summary.equilibriumDiscretization = defectOf(separate_);
}

/// u^ is tightened for the stress of the bound.
ErrorMeasure Certifier::measureStressOf(const RecoveredField& field)
{
  addOscillation(scene_, recoveryScene_, global_, options_.mode, OscillationBound::ByConstants, admissible_);
  ElementDistances distances(scene_, field);
  const bool tightens = &field == &global_ && options_.mode == ErrorMode::Strict && !scene_.patches.empty();
  ErrorMeasure measure =
      tightens ? tighten(scene_, field, admissible_, distances) : measureStress(scene_, field, admissible_, distances);
  if (!sharpenOscillation(scene_, recoveryScene_, measure))
    return measure;
  addOscillation(scene_, recoveryScene_, global_, options_.mode, OscillationBound::Sharp, admissible_);
  return measureStress(scene_, field, admissible_, distances);
}

void Certifier::measureGlobal()
{
  ErrorSummary& summary = result_.summary;
  globalMeasure_ = measureStressOf(global_);
  summary.global = summarizeMeasure(globalMeasure_, boundOf(globalMeasure_, options_.mode), scene_.norm);
  summary.meanStress = globalMeasure_.meanStress();
  summary.meanStressRelative = scene_.norm > 0.0 ? *summary.meanStress / scene_.norm : 0.0;
  const Guarantee guarantee =
      judge(scene_, global_, admissible_, options_.mode, summary.equilibrium.value_or(0.0), pointCaveat(scene_, comm_));
  summary.guaranteed = guarantee.holds();
  summary.reason = guarantee.reason();
  if (guarantee.holds())
    result_.energy = energyOf(scene_, global_, admissible_, globalMeasure_);
  result_.etaGlobal = cellContributions(globalMeasure_);
  result_.traction = global_.stress.tractions[0];
  result_.patches = scene_.patches;
  result_.intermediate = global_.field.displacement;
  result_.admissible = admissible_.displacement.displacement;
}

void Certifier::compareWithIndicators()
{
  std::vector<CellValues> smoothing, residual;
  const InterfaceState& state = scene_.coupling.state;
  SceneStress solved;
  if (wants(Estimator::Residual) && !scene_.patches.empty()) {
    solved.tractions[0] = tractionFromNodes(scene_.patches, state.tractionDirichlet, scene_.order, scene_.degree);
    solved.tractions[1] = tractionFromNodes(scene_.patches, state.tractionNeumann, scene_.order, scene_.degree);
  }
  if (wants(Estimator::Residual) && recoveryScene_.data.empty())
    recoveryScene_ = makeRecoveryScene(scene_);
  for (const int b : scene_.model.elasticBodies()) {
    const BodyModel& model = *scene_.bodies[std::size_t(b)];
    const NodalField& u = scene_.solved[std::size_t(b)];
    if (wants(Estimator::ZienkiewiczZhu))
      smoothing.push_back(ofCountedCells(model, zienkiewiczZhu(model, u)));
    if (!wants(Estimator::Residual))
      continue;
    const Vector contact = sharesOf(scene_, solved, b);
    const FieldInput input{&u.whole(), contact.empty() ? nullptr : &contact};
    const StaticData& data = recoveryScene_.data[std::size_t(b)];
    residual.push_back(ofCountedCells(model, residualIndicator(model, data, input)));
  }
  if (!smoothing.empty())
    result_.summary.zienkiewiczZhu = totalOf(smoothing, scene_.parts);
  if (!residual.empty())
    result_.summary.residual = totalOf(residual, scene_.parts);
}

void Certifier::measure()
{
  const auto timer = timeStage(ledger_, Stage::CertifyEstimators);
  ErrorSummary& summary = result_.summary;
  summary.mode = errorModeNames().name(options_.mode);
  if (options_.recoversStress()) {
    const std::string chosen = recovery_.standsFor(scene_.dim());
    summary.recovery = chosen.empty() ? options_.recovery : chosen;
    summary.degree = scene_.degree;
  }
  if (options_.needsTraction())
    summary.interfaceTraction = tractionTypeNames().name(options_.tractionWith(recovery_, scene_.dim()));
  if (wants(Estimator::Global))
    measureGlobal();
  if (wants(Estimator::Algorithm) || wants(Estimator::Split)) {
    const ErrorMeasure measure = measureAlgorithm(scene_, global_.field);
    summary.algorithm = summarizeMeasure(measure, measure.sum(), scene_.norm);
    result_.etaAlgorithm = cellContributions(measure);
  }
  if (wants(Estimator::Discretization)) {
    const ErrorMeasure measure = measureStressOf(separate_);
    summary.discretization = summarizeMeasure(measure, boundOf(measure, options_.mode), scene_.norm);
    result_.etaDiscretization = cellContributions(measure);
  }
  if (wants(Estimator::Split))
    summary.splitStress = correctionNorm(scene_, global_);
  compareWithIndicators();
  summary.advice = advice(summary, scene_.coupling.history);
  result_.corrections = std::move(global_.stress.corrections);
  result_.pieces = std::move(global_.stress.pieces);
}

void Certifier::compare(const CertificateComponents& components, std::shared_ptr<const ReferenceSolution>& reference)
{
  const auto timer = timeStage(ledger_, Stage::CertifyReference);
  const CertifiedStress certified{result_.admissible, scene_.patches, result_.traction, globalMeasure_,
                                  boundOf(globalMeasure_, options_.mode)};
  const ReferenceDepth depth{options_.refinements, options_.maximumDofs};
  updateReference(reference, settings_, components, scene_.model, depth, comm_, ledger_);
  result_.summary.reference = compareWithReference(reference.get(), scene_.model, scene_.solved,
                                                   wants(Estimator::Global) ? &certified : nullptr, depth);
}

} // namespace

Certificate certify(const SceneSettings& settings, const ErrorOptions& options, const CertificateComponents& components,
                    const Model& model, const CondensedModel& condensed, const CouplingResult& coupling,
                    const std::vector<BodyFields>& fields, const Comm& comm, Ledger& ledger,
                    std::shared_ptr<const ReferenceSolution>& reference, const std::function<void()>& onFields)
{
  const auto recovery = components.recoveries.build(options.recoveryList);
  const CertifiedScene scene =
      makeScene(model, condensed, coupling, fields, recovery->degree(model.bodies.front().nodes.order), comm);
  return Certifier(settings, options, scene, *recovery, comm, ledger).run(components, reference, onFields);
}

} // namespace ndframe
