#include "ndframe/scene/holds.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mean_motions.hpp"
#include "ndframe/interface/body_trace.hpp"
#include "ndframe/scene/moment.hpp"

namespace ndframe
{
namespace
{

/// Work of the loads along a held motion, relative to all loads, that is round-off of their integrals.
constexpr double balanced = 1e-9;

/// A node whose pin would stand nearer than this to those before it (in unit motions) is no use.
constexpr double independent = 1e-6;

/// Nodes where nothing is prescribed and nothing touches; of outer cells vertices alone.
std::vector<int> untouchedNodes(const Model& model, int body)
{
  const BodyModel& here = model.bodies[std::size_t(body)];
  std::vector<char> isTouched(std::size_t(here.nodes.numNodes()), 0);
  for (const auto& entry : model.constraints[std::size_t(body)].nodes())
    isTouched[std::size_t(entry.first)] = 1;
  for (const auto& interface : model.interfaces)
    for (const InterfaceSide& side : interface.sides)
      for (const int node : side.nodes)
        if (side.body == body)
          isTouched[std::size_t(node)] = 1;
  std::vector<int> untouched;
  for (int node = 0; node < (model.isOuter() ? here.mesh.numPoints() : here.nodes.numNodes()); ++node)
    if (!isTouched[std::size_t(node)])
      untouched.push_back(node);
  return untouched;
}

/// One equation a motion, each the one that the motions left so far move most (of equal ones the first). Fewer where
/// there are no such nodes.
std::vector<NodeConstraint> choosePins(const Model& model, int body, const DenseMatrix& motions)
{
  const RigidBasis& rigid = model.rigid[std::size_t(body)];
  const NodeMap& nodes = model.bodies[std::size_t(body)].nodes;
  const std::vector<int> candidates = untouchedNodes(model, body);
  DenseMatrix left = motions;
  std::vector<NodeConstraint> pins;
  while (left.cols() > 0) {
    NodeConstraint best{-1, {}, 0.0};
    Vector bestRow;
    double longest = independent;
    for (const int node : candidates)
      for (int k = 0; k < nodes.dim; ++k) {
        Vector row;
        for (int m = 0; m < left.cols(); ++m)
          row.push_back(displacementOf(rigid, left.column(m), nodes.point(node).data())[std::size_t(k)]);
        if (norm(row) <= (1.0 + balanced) * longest)
          continue;
        longest = norm(row);
        best = {node, {}, 0.0};
        best.direction[std::size_t(k)] = 1.0;
        bestRow = row;
      }
    if (best.node < 0)
      break;
    pins.push_back(best);
    DenseMatrix equation(1, left.cols());
    std::copy(bestRow.begin(), bestRow.end(), equation.data());
    left = multiply(left, nullSpace(equation, rigidTolerance));
  }
  return pins;
}

/// The motions along which contact can push: those among `motions` that move some interface node along its normal.
DenseMatrix pushedByContact(const Model& model, int body, const DenseMatrix& motions)
{
  std::vector<const double*> points;
  std::vector<Direction> normals;
  for (const auto& interface : model.interfaces)
    for (int i = 0; i < interface.numNodes(); ++i)
      for (const ContactRole role : bothRoles)
        if (interface.side(role).body == body && !interface.touchesItself() && model.carriesContact(interface, i)) {
          points.push_back(interface.pointOf(role, i));
          normals.push_back(interface.normals[std::size_t(i)]);
        }
  if (points.empty() || motions.cols() == 0)
    return {motions.rows(), 0};
  const DenseMatrix still =
      nullSpace(motionTraces(model.rigid[std::size_t(body)], motions, points, normals), rigidTolerance);
  DenseMatrix rows(still.cols(), still.rows());
  for (int i = 0; i < rows.rows(); ++i)
    for (int j = 0; j < rows.cols(); ++j)
      rows(i, j) = still(j, i);
  return multiply(motions, nullSpace(rows, rigidTolerance));
}

/// HeldMean::means
std::vector<NodalField> meansOf(const Model& model, const HeldMean& hold)
{
  const BodyModel& body = model.bodies[std::size_t(hold.body)];
  const Params& params = body.supports[hold.support]->params();
  std::vector<NodalField> means;
  for (int m = 0; m < hold.motions.cols(); ++m)
    means.push_back(
        atNodes(meanWeights(body, params, model.rigid[std::size_t(hold.body)], hold.motions.column(m)), body.mesh.dim));
  return means;
}

/// Fixes what one Hold holds; the body is held from then on.
void resolveHold(Model& model, int body, std::size_t support, Diagnostics& diagnostics)
{
  const auto b = std::size_t(body);
  BodyModel& here = model.bodies[b];
  const Params& params = here.supports[support]->params();
  HeldMean hold{body, support, partOf(freeTogether(model), offsetOf(model, body), model.rigid[b].size()), {}, {}};
  hold.pins = choosePins(model, body, hold.motions);
  if (model.isOuter() && int(hold.pins.size()) < hold.motions.cols())
    throw InsideNeeded();
  if (hold.motions.cols() == 0 || int(hold.pins.size()) < hold.motions.cols()) {
    diagnostics.add(params.mistake("", hold.motions.cols() == 0
                                           ? "supports and contact hold all motions of this body already; remove it."
                                           : "finds no nodes away from supports and contact; make the mesh finer."));
    return;
  }
  hold.means = meansOf(model, hold);
  here.supports[support]->pin(hold.pins);
  model.constraints[b] = collectConstraints(here.supports, here.mesh, here.nodes);
  model.freeMotions[b] = nullSpace(supportRows(model.rigid[b], here.nodes, model.constraints[b]), rigidTolerance);
  model.holds.push_back(std::move(hold));
}

/// What the loads leave to the pins of all Holds: sum over pins of lambda_i (motion at pin i) + work of the loads = 0
/// for every joint motion.
Vector pinForces(const Model& model, const Vector& work)
{
  std::vector<Vector> rows;
  for (const HeldMean& hold : model.holds)
    for (const auto& pin : hold.pins) {
      Vector row;
      for (int j = 0; j < model.jointMotions.cols(); ++j)
        row.push_back(dotProduct(pin.direction,
                                 displacementOf(model.rigid[std::size_t(hold.body)],
                                                ofBody(model, model.jointMotions, j, hold.body),
                                                model.bodies[std::size_t(hold.body)].nodes.point(pin.node).data())));
      rows.push_back(std::move(row));
    }
  DenseMatrix moved(int(work.size()), int(rows.size()));
  for (int i = 0; i < moved.cols(); ++i)
    std::copy(rows[std::size_t(i)].begin(), rows[std::size_t(i)].end(), moved.col(i));
  return multiply(pseudoInverse(moved, rigidTolerance), work);
}

/// Force and moment about the body's centre of forces on the pins of a Hold.
std::string resultantText(const Model& model, const HeldMean& hold, const double* forces)
{
  const auto b = std::size_t(hold.body);
  const int dim = model.bodies[b].mesh.dim;
  Vector force(std::size_t(dim), 0.0), moment(dim == 2 ? 1 : 3, 0.0);
  for (std::size_t i = 0; i < hold.pins.size(); ++i) {
    Direction part{}, arm{};
    for (std::size_t k = 0; k < force.size(); ++k) {
      part[k] = forces[i] * hold.pins[i].direction[k];
      arm[k] = model.bodies[b].nodes.point(hold.pins[i].node)[k] - model.rigid[b].centre[k];
      force[k] += part[k];
    }
    const auto turning = momentOf(arm, part, dim);
    for (std::size_t k = 0; k < moment.size(); ++k)
      moment[k] += turning[k];
  }
  const double largest = std::max(largestEntry(force), largestEntry(moment));
  for (Vector* const part : {&force, &moment})
    std::replace_if(
        part->begin(), part->end(), [&](double x) { return std::abs(x) <= balanced * largest; }, 0.0);
  return fmt::format("a force ({:.3g}) and a moment ({:.3g}) about {}", fmt::join(force, ", "), fmt::join(moment, ", "),
                     pointText(model.rigid[b].centre.data(), dim));
}

void refuseImbalance(const Model& model, Diagnostics& diagnostics)
{
  double loads = 0.0, largest = 0.0;
  Vector work(std::size_t(model.jointMotions.cols()), 0.0);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const NodalField all = model.loads[b].all();
    for (const double force : all)
      loads += std::abs(force);
    const ForcesInside inside = model.inside[b].value_or(ForcesInside());
    loads += inside.sum;
    for (std::size_t j = 0; j < work.size(); ++j) {
      const Vector motion = ofBody(model, model.jointMotions, int(j), int(b));
      work[j] += workAlong(model.bodies[b], model.rigid[b], motion, all);
      for (std::size_t mode = 0; mode < inside.work.size(); ++mode)
        work[j] += motion[mode] * inside.work[mode];
    }
  }
  const Vector forces = pinForces(model, work);
  largest = largestEntry(forces);
  if (largest <= balanced * loads)
    return;
  const double* next = forces.data();
  for (const HeldMean& hold : model.holds) {
    const double* const own = next;
    next += hold.pins.size();
    const bool carries = std::any_of(own, next, [&](double force) { return std::abs(force) > balanced * loads; });
    const Support& support = *model.bodies[std::size_t(hold.body)].supports[hold.support];
    if (carries)
      diagnostics.add(support.params().mistake(
          "", fmt::format("the loads are not in equilibrium along what it holds ({}): {} are left, and a Hold carries "
                          "none. Balance the loads, or support a side.",
                          heldMotions(model, hold.body, hold.support), resultantText(model, hold, own))));
  }
}

} // namespace

void resolveHolds(Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  model.balancedMotions = model.freeMotions;
  const bool any = std::any_of(model.bodies.begin(), model.bodies.end(), [](const BodyModel& body) {
    return std::any_of(body.supports.begin(), body.supports.end(), [](const auto& s) { return s->holdsMeanMotion(); });
  });
  if (!any)
    return;
  model.jointMotions = freeTogether(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (std::size_t s = 0; s < model.bodies[b].supports.size(); ++s)
      if (model.bodies[b].supports[s]->holdsMeanMotion()) {
        model.balancedMotions[b] = pushedByContact(model, int(b), model.balancedMotions[b]);
        resolveHold(model, int(b), s, diagnostics);
      }
  checkHeld(model, scene, diagnostics);
  if (diagnostics.empty())
    refuseImbalance(model, diagnostics);
}

void takeHolds(Model& model)
{
  model.jointMotions = model.told->jointMotions;
  for (const ToldHold& told : model.told->holds) {
    HeldMean hold{told.body, std::size_t(told.support), told.motions, {}, {}};
    hold.means = meansOf(model, hold);
    model.holds.push_back(std::move(hold));
  }
}

std::string heldMotions(const Model& model, int body, std::size_t support)
{
  for (const HeldMean& hold : model.holds)
    if (hold.body == body && hold.support == support)
      return fmt::format("{}", fmt::join(describeMotions(model.rigid[std::size_t(body)], hold.motions), ", "));
  return {};
}

} // namespace ndframe
