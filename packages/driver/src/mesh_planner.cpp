#include "mesh_planner.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{
namespace
{

// Chosen where `punch` and `contact-loss` need the fewest dofs in all for 1 % to 0.1 % (docs/accuracy.md).

/// The bound of a mesh is to be at least this part of the one before. With less there are fewer levels, but predictions
/// do not reach that far.
constexpr double largestFall = 0.32;
/// A level is worth its work if the bound falls to this part at least.
constexpr double smallestFall = 0.93;
/// Conformity adds cells that a prediction leaves out; they make the error this much smaller.
constexpr double gainOfConformity = 1.02;
/// It adds that many dofs at most.
constexpr double roomForConformity = 1.1;
/// How far a prediction is corrected by what became of the one before.
constexpr double leastOptimism = 0.95, mostOptimism = 1.2;

/// With a larger relative bound nothing can be learned about corners: cells are larger than what they shall show.
constexpr double tooCoarse = 0.3;

std::vector<Mesh> meshesOf(const Model& model)
{
  std::vector<Mesh> meshes;
  for (const auto& body : model.bodies)
    meshes.push_back(body.mesh);
  return meshes;
}

std::vector<FacetTwin> twinsOf(const Model& model)
{
  std::vector<FacetTwin> twins;
  for (const auto& interface : model.interfaces)
    for (int f = 0; f < interface.numFacets(); ++f)
      twins.push_back({interface.dirichletBody, interface.dirichletFacets[std::size_t(f)], interface.neumannBody,
                       interface.neumannFacets[std::size_t(f)]});
  return twins;
}

} // namespace

MeshPlanner::MeshPlanner(const Model& model)
    : degree_(model.bodies.front().nodes.order), bisection_(meshesOf(model), twinsOf(model)), exponents_(degree_)
{}

void MeshPlanner::learn(const Run& run, const LevelErrors& errors)
{
  const auto& eta = run.certificate->etaGlobal;
  std::int64_t cells = 0;
  double squared = 0.0;
  std::vector<const Mesh*> meshes;
  for (std::size_t b = 0; b < eta.size(); ++b) {
    meshes.push_back(&run.model.bodies[b].mesh);
    cells += meshes.back()->numCells();
    squared += dot(eta[b], eta[b]);
  }
  if (expected_ > 0.0)
    optimism_ = std::clamp(errors.bound / expected_, leastOptimism, mostOptimism);
  if (errors.relative > tooCoarse)
    exponents_ = CornerExponents(degree_);
  exponents_.observe(meshes, eta);
  refinement_.emplace(bisection_.meshes(), eta, exponents_, degree_);
  bound_ = errors.bound;
  target_ = errors.target;
  total_ = std::sqrt(squared);
  numDofs_ = run.model.totalDofs();
  dofsPerCell_ = double(numDofs_) / double(cells);
}

MeshPlan MeshPlanner::planFor(double wanted) const
{
  const double boundPerTotal = optimism_ * bound_ / total_;
  MeshPlan plan;
  plan.prediction = refinement_->predict(gainOfConformity * wanted / boundPerTotal);
  plan.dofs = std::int64_t(dofsPerCell_ * double(plan.prediction.numCells));
  plan.bound = plan.prediction.error * boundPerTotal;
  return plan;
}

MeshPlan MeshPlanner::nextStep(std::int64_t maximumDofs) const
{
  const double steps = std::max(1.0, std::ceil(std::log(target_ / bound_) / std::log(largestFall)));
  double wanted = bound_ * std::min(smallestFall, std::pow(target_ / bound_, 1.0 / steps));
  MeshPlan plan = planFor(wanted);
  while (roomForConformity * double(plan.dofs) > double(maximumDofs) && wanted < bound_)
    plan = planFor(wanted *= 1.05);
  return plan;
}

void MeshPlanner::refine(const MeshPlan& plan)
{
  refinement_->apply(bisection_, plan.prediction);
  expected_ = plan.bound;
}

} // namespace ndframe
