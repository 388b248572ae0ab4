#include "certificate_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "intermediate_fields.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/jump_coefficients.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/admissibility/sign_conditions.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{
namespace
{

/// The dofs of the bodies in contact.
std::vector<int> traceSizes(const CertifiedScene& scene)
{
  std::vector<int> sizes;
  const std::vector<int> all = scene.model.numDofs();
  for (const auto& trace : scene.condensed.interface.bodies)
    sizes.push_back(all[std::size_t(trace.body)]);
  return sizes;
}

} // namespace

double shareOf(int dim, int order, std::size_t node)
{
  if (order == 1)
    return 1.0 / dim;
  return (node < std::size_t(dim) ? 3.0 - dim : 4.0) / (dim * (dim + 1));
}

void Guarantee::require(bool holds, const std::string& otherwise)
{
  if (!holds && reason_.empty())
    reason_ = otherwise;
}

void Guarantee::accept(const std::string& caveat)
{
  require(caveat.empty(), caveat.substr(0, caveat.find_last_not_of(". ") + 1));
}

CertifiedScene makeScene(const Model& model, const CondensedModel& condensed, const CouplingResult& coupling,
                         const std::vector<BodyFields>& fields, int degree, const Comm& comm)
{
  CertifiedScene scene{model,
                       condensed,
                       coupling,
                       fields,
                       {},
                       {},
                       contactPatches(model),
                       0,
                       degree,
                       0.0,
                       comm,
                       model.told ? comm : Comm::single()};
  double total = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    scene.bodies.push_back(&model.bodies[b]);
    scene.solved.push_back(fields[b].displacement.back());
    total += energy(model.bodies[b], scene.solved.back(), comm);
  }
  scene.order = model.bodies.front().nodes.order;
  scene.norm = std::sqrt(std::max(total, 0.0));
  return scene;
}

namespace
{

StaticData withoutData(const BodyModel& body, int degree)
{
  StaticData data;
  data.dim = body.mesh.dim;
  data.order = body.nodes.order;
  data.degree = degree;
  data.oscillation.assign(std::size_t(body.mesh.numCells()), 0.0);
  return data;
}

} // namespace

RecoveryScene makeRecoveryScene(const CertifiedScene& scene)
{
  RecoveryScene result;
  result.bodies = scene.bodies;
  result.patches = scene.patches;
  result.data.resize(scene.bodies.size());
  runLargestFirst(scene.model.numDofs(), scene.condensed.threads, [&](int body) {
    const auto b = std::size_t(body);
    std::vector<Facet> contact;
    for (const BodyPatch& own : patchesOfBody(scene.patches, body))
      contact.push_back(scene.patches[own.patch].sides[own.side].facet);
    if (scene.bodies[b]->isRigid) { // no stress, no data
      result.data[b] = withoutData(*scene.bodies[b], scene.degree);
      return;
    }
    result.data[b] = makeStaticData(*scene.bodies[b], scene.degree, std::move(contact), OscillationBound::ByConstants);
  });
  return result;
}

SceneField makeSceneField(const IntermediateField& field)
{
  SceneField result;
  for (const NodalField& displacement : field.displacement)
    result.displacement.push_back(&displacement.whole());
  result.tractions = field.tractions;
  return result;
}

Vector sharesOf(const CertifiedScene& scene, const SceneStress& stress, int body)
{
  return contactShares(scene.patches, stress.tractions, body);
}

Vector nodalGap(const Model& model)
{
  Vector gap;
  for (const auto& interface : model.interfaces)
    gap.insert(gap.end(), interface.gap.begin(), interface.gap.end());
  return gap;
}

double largestTension(const CertifiedScene& scene, const ContactTraction& traction)
{
  ContactTraction opposite = traction;
  for (double& share : opposite.shares)
    share = -share;
  const double tension = largestSign(traction, scene.patches), scale = largestSign(opposite, scene.patches);
  return scale > 0.0 ? tension / scale : tension;
}

Vector admitNodal(const CertifiedScene& scene, const Vector& nodal, TractionSign sign, const Vector& cost)
{
  const auto balance = balanceConditions(scene.model, scene.condensed, scene.patches, scene.parts);
  Vector admitted(nodal.size(), 0.0);
  std::string motion;
  if (scene.comm.rank() == 0) // the program takes 20 kB a node, and all ranks have the same one
    try {
      admitted =
          projectTraction(scene.patches, scene.condensed.interface.C->size(), scene.order, nodal, balance, sign, cost);
    } catch (const InfeasibleTraction& failure) {
      motion = failure.motion;
      NDFRAME_ASSERT(!motion.empty(), "what is not balanced has a name");
    }
  scene.comm.broadcast(motion);
  if (!motion.empty())
    throw NotConverged(fmt::format("no pressure on the interfaces balances the loads ({}): they act too close to the "
                                   "edge of contact, so there is no equilibrated stress and no bound. Hold the body or "
                                   "move its load",
                                   motion));
  scene.comm.broadcast(admitted);
  return admitted;
}

ContactTraction admitTraction(const CertifiedScene& scene, const Vector& nodal, TractionSign sign, const Vector& cost)
{
  return tractionFromNodes(scene.patches, admitNodal(scene, nodal, sign, cost), scene.order, scene.degree);
}

bool measuresFields(const ErrorOptions& options)
{
  return options.mode == ErrorMode::Paper || options.wants(Estimator::Algorithm) ||
         options.wants(Estimator::Discretization) || options.wants(Estimator::Split);
}

double largestDisplacement(const CertifiedScene& scene, const std::vector<NodalField>& fields)
{
  Vector value{0.0};
  for (const NodalField& field : fields)
    for (const double entry : field)
      value[0] = std::max(value[0], std::abs(entry));
  takeLargest(value, scene.parts);
  return value[0];
}

bool areOfOneSize(const CertifiedScene& scene)
{
  constexpr double most = 100.0; // sizes differ by less than five
  Vector smallest{std::numeric_limits<double>::infinity()}, largest{0.0};
  for (const BodyModel* body : scene.bodies)
    for (int cell = 0; cell < body->mesh.numCells() && !body->isRigid; ++cell) {
      const double measure = cellMeasure(body->mesh, cell);
      smallest[0] = std::min(smallest[0], measure);
      largest[0] = std::max(largest[0], measure);
    }
  takeExtremes(smallest, largest, scene.parts);
  return largest[0] <= most * smallest[0];
}

void solveFields(const CertifiedScene& scene, std::vector<IntermediateField*> fields, bool areNear)
{
  constexpr double enough = 1e-6; // of the energy: a bound of 1 % has a square of 1e-4
  const FieldNeed need{areNear, enough * scene.norm * scene.norm, scene.comm};
  for (auto* field : fields)
    field->displacement = scene.solved;
  const auto& traces = scene.condensed.interface.bodies;
  runLargestFirst(traceSizes(scene), scene.condensed.threads, [&](int i) {
    const BodyTrace& trace = traces[std::size_t(i)];
    const auto b = std::size_t(trace.body);
    std::vector<NodalField> forces;
    for (const auto* field : fields) {
      forces.push_back(
          atNodes(contactForces(*scene.bodies[b], trace.body, scene.patches, field->tractions), scene.dim()));
    }
    const Vector known = solvedForces(scene.condensed, trace.body, scene.coupling.state);
    auto solutions = intermediateFields(scene.model, scene.condensed, trace.body, forces, known, scene.solved[b], need);
    for (std::size_t f = 0; f < fields.size(); ++f)
      fields[f]->displacement[b] = std::move(solutions[f]);
  });
}

GapBound contactGap(const CertifiedScene& scene, ErrorMode mode)
{
  if (scene.patches.empty())
    return {};
  if (mode == ErrorMode::Paper) {
    Vector gap; // of the deck: closing() has what the geometry says
    for (const auto& interface : scene.model.interfaces)
      for (std::size_t i = 0; i < interface.gap.size(); ++i)
        gap.push_back(interface.gap[i] - (interface.drawnGap.empty() ? 0.0 : interface.drawnGap[i]));
    return {{}, nodalMoments(scene.patches, gap, scene.order, scene.degree), {}};
  }
  std::vector<PatchGap> gaps;
  for (const auto& interface : scene.model.interfaces)
    gaps.push_back({interface.numFacets(), interface.gapFunction});
  return boundGap(scene.bodies, scene.patches, scene.degree, gaps);
}

std::vector<const ConstraintSet*> constraintsOf(const Model& model)
{
  std::vector<const ConstraintSet*> constraints;
  for (const auto& set : model.constraints)
    constraints.push_back(&set);
  return constraints;
}

AdmissibleDisplacement admitDisplacements(const CertifiedScene& scene, const GapBound& gap, ErrorMode mode)
{
  if (mode == ErrorMode::Paper || scene.patches.empty())
    return {scene.solved, 0.0, 0, {}};
  return admitDisplacement(scene.bodies, constraintsOf(scene.model), scene.patches, gap, scene.solved, scene.parts);
}

Vector openings(const CertifiedScene& scene, const std::vector<NodalField>& displacement, const GapBound& gap)
{
  return difference(closingMoments(scene.bodies, scene.patches, displacement, scene.degree), gap.moments);
}

double largestPenetration(const CertifiedScene& scene, const std::vector<NodalField>& displacement, const GapBound& gap)
{
  double deepest = 0.0;
  for (std::size_t f = 0; f < scene.patches.size(); ++f) {
    const JumpCoefficients jump{scene.patches[f], scene.order};
    const auto opening = closing(scene.bodies, scene.patches[f], displacement);
    const double* bound = gap.bernstein.data() + f * scene.patches[f].numNodes(scene.order);
    for (std::size_t k = 0; k < jump.size(); ++k)
      deepest = std::max(deepest, jump.of(k, opening) - jump.gap(k, bound));
  }
  const double scale = largestDisplacement(scene, displacement);
  return scale > 0.0 ? deepest / scale : deepest;
}

} // namespace ndframe
