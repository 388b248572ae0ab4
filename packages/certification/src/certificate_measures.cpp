#include "certificate_measures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "element_distances.hpp"
#include "intermediate_fields.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/prescribed_charge.hpp"
#include "ndframe/admissibility/tighten_displacement.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/equilibrium_check.hpp"
#include "ndframe/equilibrium/settle_balance.hpp"
#include "ndframe/recovery/scene_pieces.hpp"

namespace ndframe
{
namespace
{

/// A star whose forces are out of balance by more than this (relative) was not given a finite element solution.
constexpr double largestDefect = 1e-9;
/// Signs are met up to this, relative to the field.
constexpr double roundOff = 1e-12;
/// A contact term below this, relative to the elements', is not worth work.
constexpr double seen = 1e-6;

/// Of the forces at a node, relative to the largest; 0 without any. The computed solution's energy over its
/// displacement is a force, too: where the admissible field has none (contact that turns out open), what is left of it
/// is round-off.
double largestImbalance(const CertifiedScene& scene, const RecoveredField& recovered)
{
  double imbalance = 0.0;
  const double displacement = largestDisplacement(scene, scene.solved);
  double force = displacement > 0.0 ? scene.norm * scene.norm / displacement : 0.0;
  for (const auto& correction : recovered.stress.corrections) {
    force = std::max(force, correction.force);
    imbalance = std::max(imbalance, correction.imbalance);
  }
  return imbalance > 0.0 ? imbalance / force : 0.0;
}

/// Whether the coupling solved both bodies of an interface with the same traction. What it is wrong by is then not in
/// the tractions but in the displacements, which meet the gap only so far.
bool areOne(const InterfaceState& state)
{
  return state.tractionDirichlet == state.tractionNeumann;
}

/// The root of the contact term, with its sign: where u^ penetrates (Paper mode) it takes away from the measure.
double contactRoot(double contact, double norm)
{
  if (contact < 0.0 && contact >= -roundOff * norm * norm)
    return 0.0;
  return std::copysign(std::sqrt(std::abs(contact)), contact);
}

/// |K eps(u_h) - s_m| = |c + K eps(u~ - (2 u_h - u^))| / 2: where u^ is u_h this has been measured already.
double distanceFromMean(const CertifiedScene& scene, const AdmissibleScene& admissible, ElementDistances& distances)
{
  std::vector<NodalField> mirrored;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Vector v = scene.solved[b];
    for (std::size_t i = 0; i < v.size() && !scene.bodies[b]->isRigid; ++i)
      v[i] = 2.0 * v[i] - admissible.displacement.displacement[b][i];
    mirrored.push_back(atNodes(std::move(v), scene.dim()));
  }
  return 0.5 * totalOf(distances.to(mirrored), scene.parts);
}

} // namespace

AdmissibleScene admitScene(const CertifiedScene& scene, const RecoveryScene& recovery, ErrorMode mode)
{
  AdmissibleScene result;
  result.gap = contactGap(scene, mode);
  result.displacement = admitDisplacements(scene, result.gap, mode);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (scene.bodies[b]->isRigid)
      continue;
    const auto prescribed = chargePrescribed(*scene.bodies[b], scene.parts);
    result.prescribed += prescribed.charge;
    for (const auto& caveat : {recovery.data[b].caveat, prescribed.caveat})
      if (result.caveat.empty())
        result.caveat = firstText(caveat, scene.parts);
  }
  return result;
}

void setOpening(const CertifiedScene& scene, const IntermediateField& field, const AdmissibleScene& admissible,
                SceneField& input)
{
  input.opening = openings(scene, field.displacement, admissible.gap);
  if (scene.dim() == 2)
    return;
  const std::vector<NodalField>& to = admissible.displacement.displacement;
  input.beside = std::pow(changeInEnergy(scene.bodies, field.displacement, to, scene.parts), 2);
  const Vector closed = difference(openings(scene, to, admissible.gap), input.opening);
  for (const double twice : contactContributions(scene.patches, field.tractions[0], closed))
    input.beside += twice;
}

ErrorMeasure measureStress(const CertifiedScene& scene, const RecoveredField& recovered,
                           const AdmissibleScene& admissible, ElementDistances& distances)
{
  Vector contact;
  if (!scene.patches.empty()) {
    contact = contactContributions(scene.patches, recovered.stress.tractions[0],
                                   openings(scene, admissible.displacement.displacement, admissible.gap));
    addUnsureGap(scene.patches, recovered.stress.tractions[0], admissible.gap.unsure, contact);
  }
  ErrorMeasure measure = assembleMeasure(distances.to(admissible.displacement.displacement), scene.patches, contact,
                                         admissible.oscillation, scene.parts);
  measure.prescribed = admissible.prescribed;
  measure.projection = admissible.displacement.charge;
  if (measure.projection > 0.0)
    measure.aside = distanceFromMean(scene, admissible, distances);
  return measure;
}

ErrorMeasure measureAlgorithm(const CertifiedScene& scene, const IntermediateField& field)
{
  std::vector<CellValues> energies(scene.bodies.size());
  runLargestFirst(scene.model.numDofs(), scene.condensed.threads, [&](int body) {
    const auto b = std::size_t(body);
    const BodyModel& model = *scene.bodies[b];
    Vector own = cellEnergies(model, difference(field.displacement[b], scene.solved[b]), countedCells(model));
    own.resize(std::size_t(model.mesh.numCells()), 0.0);
    energies[b] = ofCells(std::move(own));
  });
  const Vector gap = nodalMoments(scene.patches, nodalGap(scene.model), scene.order, scene.degree);
  const Vector opening = difference(jumpMoments(scene.bodies, scene.patches, scene.solved, scene.degree), gap);
  ErrorMeasure measure =
      assembleMeasure(std::move(energies), scene.patches,
                      contactContributions(scene.patches, field.tractions[0], opening), {}, scene.parts);
  if (areOne(scene.coupling.state))
    measure.projection = scene.coupling.history.back().iterationError.value_or(0.0);
  return measure;
}

double correctionNorm(const CertifiedScene& scene, const RecoveredField& recovered)
{
  std::vector<CellValues> energies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b]->isRigid)
      energies.push_back(elementDistances(scene, b, recovered.stress, nullptr));
  return totalOf(energies, scene.parts);
}

void settle(const CertifiedScene& scene, const RecoveryScene& recovery, const std::vector<RecoveredField*>& recovered,
            Ledger& ledger)
{
  const std::size_t bodies = scene.bodies.size();
  std::vector<int> sizes;
  for (std::size_t f = 0; f < recovered.size(); ++f)
    for (const BodyModel* body : scene.bodies)
      sizes.push_back(body->numDofs());
  const auto settleOne = [&](int i) {
    RecoveredField& field = *recovered[std::size_t(i) / bodies];
    const std::size_t b = std::size_t(i) % bodies;
    StressCorrection& correction = field.stress.corrections[b];
    if (scene.bodies[b]->isRigid)
      return;
    const BodyModel& held = field.stress.pieces ? field.stress.pieces->bodies[b]->model : *scene.bodies[b];
    if (!needsSettling(held.mesh, correction, field.stress.pieces ? scene.comm : Comm::single()))
      return;
    const Vector contact = sharesOf(scene, field.stress, int(b));
    ledger.count("settled stresses");
    if (field.stress.pieces) {
      const BodyPiece& piece = *field.stress.pieces->bodies[b];
      const Vector ofPiece = piece.ofContact(contact);
      settleBalance(piece, {&field.field.displacement[b].whole(), &ofPiece}, correction, scene.comm);
    } else
      settleBalance(*scene.bodies[b], recovery.data[b], {&field.field.displacement[b].whole(), &contact}, correction);
  };
  if (recovered.empty() || !recovered.front()->stress.pieces)
    runLargestFirst(sizes, scene.condensed.threads, settleOne);
  for (int i = 0; i < int(sizes.size()) && recovered.front()->stress.pieces; ++i) // all ranks in one order
    settleOne(i);
}

double equilibriumDefect(const CertifiedScene& scene, const RecoveryScene& recovery, const RecoveredField& recovered)
{
  double largest = 0.0, scale = 0.0;
  for (const int body : scene.model.elasticBodies()) {
    const auto b = std::size_t(body);
    const Vector contact = sharesOf(scene, recovered.stress, body);
    const StressCorrection& correction = recovered.stress.corrections[b];
    const FieldInput input{&recovered.field.displacement[b].whole(), &contact};
    const BodyPiece* piece = recovered.stress.pieces ? recovered.stress.pieces->bodies[b].get() : nullptr;
    const Vector held = piece == nullptr ? Vector() : piece->ofContact(contact);
    const auto defects = piece == nullptr
                             ? checkEquilibrium(*scene.bodies[b], recovery.data[b], input, correction)
                             : checkEquilibrium(*piece, {input.displacement, &held}, correction, scene.comm);
    largest = std::max(largest, defects.largest() * defects.scale);
    scale = std::max(scale, defects.scale);
  }
  return scale > 0.0 ? largest / scale : 0.0;
}

Guarantee judge(const CertifiedScene& scene, const RecoveredField& recovered, const AdmissibleScene& admissible,
                ErrorMode mode, double equilibrium, const std::string& pointCaveat)
{
  Guarantee guarantee;
  guarantee.require(mode == ErrorMode::Strict, "Mode is Paper");
  guarantee.accept(pointCaveat);
  guarantee.accept(geometryCaveat(scene.model));
  guarantee.accept(admissible.caveat);
  guarantee.accept(admissible.gap.caveat);
  guarantee.accept(admissible.displacement.caveat);
  const double imbalance = largestImbalance(scene, recovered);
  guarantee.require(
      imbalance <= largestDefect,
      fmt::format("the forces are out of balance by {:.1e} of the largest at a node (limit {:.0e}): a loose "
                  "tolerance of the linear solver, or round-off in small cells",
                  imbalance, largestDefect));
  guarantee.require(equilibrium <= largestDefect,
                    fmt::format("the equilibrated stress is out of balance by {:.1e}", equilibrium));
  if (scene.patches.empty() || mode == ErrorMode::Paper)
    return guarantee;
  const double tension = largestTension(scene, recovered.stress.tractions[0]),
               penetration = largestPenetration(scene, admissible.displacement.displacement, admissible.gap);
  guarantee.require(tension <= roundOff,
                    fmt::format("the admissible traction pulls somewhere, by {:.1e} of the largest", tension));
  guarantee.require(
      penetration <= roundOff,
      fmt::format("the admissible displacement penetrates somewhere, by {:.1e} of the largest", penetration));
  return guarantee;
}

ErrorMeasure tighten(const CertifiedScene& scene, const RecoveredField& recovered, AdmissibleScene& admissible,
                     ElementDistances& distances)
{
  AdmissibleScene asSolved = admissible;
  asSolved.displacement = {scene.solved, 0.0, 0, {}};
  ErrorMeasure measure = measureStress(scene, recovered, asSolved, distances);
  if (admissible.displacement.moved == 0 && measure.contact <= seen * measure.elements * measure.elements)
    return measure; // u^ is u_h
  BoundOfDisplacement bound{measure.elements, 0.5 * measure.contact, {}, {}};
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneStress& stress = recovered.stress;
    bound.traction.push_back(
        atNodes(contactForces(*scene.bodies[b], int(b), scene.patches, stress.tractions), scene.dim()));
    const Vector solved = scene.condensed.trace(int(b)) != nullptr
                              ? solvedForces(scene.condensed, int(b), scene.coupling.state)
                              : Vector(bound.traction.back().size(), 0.0);
    bound.residual.push_back(atNodes(difference(bound.traction.back(), solved), scene.dim()));
  }
  tightenDisplacement(scene.bodies, constraintsOf(scene.model), scene.patches, admissible.gap, scene.solved, bound,
                      admissible.displacement, scene.parts);
  return measureStress(scene, recovered, admissible, distances);
}

std::optional<EnergyBracket> energyOf(const CertifiedScene& scene, const RecoveredField& recovered,
                                      const AdmissibleScene& admissible, const ErrorMeasure& measure)
{
  double strainEnergy = 0.0, work = 0.0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Vector& displacement = admissible.displacement.displacement[b];
    strainEnergy += energy(*scene.bodies[b], displacement, scene.comm);
    Vector ofBody{dot(scene.model.loads[b].all(), displacement)}; // shares have loads at own nodes
    scene.parts.sum(ofBody);
    work += ofBody.front();
    if (measure.prescribed > 0.0 && !scene.bodies[b]->loads.empty())
      return std::nullopt;
  }
  return bracketEnergy(measure, strainEnergy, work, largestImbalance(scene, recovered));
}

double boundOf(const ErrorMeasure& measure, ErrorMode mode)
{
  return mode == ErrorMode::Strict ? measure.bound() : measure.sum();
}

ErrorMeasureSummary summarizeMeasure(const ErrorMeasure& measure, double absolute, double norm)
{
  return {absolute,           norm > 0.0 ? absolute / norm : 0.0,
          measure.elements,   contactRoot(measure.contact, norm),
          measure.projection, measure.oscillation + measure.prescribed};
}

std::vector<CellValues> cellContributions(const ErrorMeasure& measure)
{
  std::vector<CellValues> all;
  for (const Vector& cells : measure.cells)
    all.push_back(contributions(cells));
  return all;
}

} // namespace ndframe
