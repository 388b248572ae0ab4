#include "reference_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "contact_scene.hpp"
#include "fine_traction.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/base/log.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/condensation/solution.hpp"
#include "ndframe/fem/prolongation.hpp"
#include "ndframe/mesh/refine.hpp"

namespace ndframe
{
namespace
{

std::unique_ptr<LinearSolver> chooseSolver(const Params& asked, const CertificateComponents& components)
{
  const auto& solvers = components.linearSolvers;
  const std::string type = asked.get<std::string>("Type");
  const bool isIterative = type == "Krylov" || type == "Multigrid"; // chosen for its memory
  return isIterative ? solvers.build(asked) : solvers.build({"Type=Automatic"});
}

/// The meshes with the vertices of paired sides at the same place: pairing compares distances with the shortest facet,
/// which refinement makes shorter.
std::vector<Mesh> matchingMeshes(const Model& model)
{
  std::vector<Mesh> meshes;
  for (const auto& body : model.bodies)
    meshes.push_back(body.mesh);
  for (const auto& interface : model.interfaces) {
    if (interface.map)
      continue;
    const Mesh& fixed = meshes[std::size_t(interface.dirichlet().body)];
    Mesh& moved = meshes[std::size_t(interface.neumann().body)];
    for (std::size_t i = 0; i < interface.dirichlet().nodes.size(); ++i)
      if (const int node = interface.neumann().nodes[i]; node < moved.numPoints())
        std::copy_n(fixed.point(interface.dirichlet().nodes[i]), moved.dim,
                    moved.points.begin() + std::ptrdiff_t(node) * moved.dim);
  }
  return meshes;
}

std::vector<NodalField> difference(std::vector<NodalField> a, const std::vector<NodalField>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k)
      a[i][k] -= b[i][k];
  return a;
}

/// Errors below this, relative to the solution, are round-off of the comparison: nothing to divide by.
constexpr double smallestError = 1e-7;

std::optional<double> ratio(double bound, double error, double size)
{
  return error > smallestError * size ? std::optional(bound / error) : std::nullopt;
}

/// Limit of a reference's dofs; in space a factor takes more memory for each.
std::int64_t affordableDofs(const Model& model, const ReferenceDepth& depth)
{
  constexpr std::int64_t inPlane = 2000000, inSpace = 400000;
  if (depth.maximumDofs > 0)
    return depth.maximumDofs;
  return model.bodies.front().mesh.dim == 2 ? inPlane : inSpace;
}

/// Nodes multiply by 2^dim with every refinement (a little less).
int affordableRefinements(const Model& model, const ReferenceDepth& depth)
{
  std::int64_t dofs = model.totalDofs();
  const int children = numChildren(model.bodies.front().mesh.dim);
  int refinements = 0;
  while (refinements < depth.refinements && (dofs *= children) <= affordableDofs(model, depth))
    ++refinements;
  return refinements;
}

} // namespace

ReferenceSolution::ReferenceSolution(const SceneSettings& settings, const CertificateComponents& components,
                                     const Model& model, int refinements, const Comm& comm)
    : comm_(comm), refinements_(refinements), recipe_(model.recipe)
{
  std::vector<Mesh> meshes = matchingMeshes(model);
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    coarser_.emplace_back();
    for (int level = 0; level < refinements; ++level) {
      coarser_[b].push_back(makeNodeMap(meshes[b], model.bodies[b].nodes.order));
      meshes[b] = refineUniformly(meshes[b]);
    }
  }
  model_ = buildModel(
      settings, components,
      [&](const BodySettings& body) { return std::move(meshes[std::size_t(model.bodyIndex(body.name))]); },
      model.interfaces, numThreads(comm));
  orientLike(model_, model.interfaces);

  Ledger ledger;
  const auto solver = chooseSolver(settings.linearSolver, components);
  const Params operatorList = components.interfaceOperators.validated({"Type=Automatic"});
  const auto representation = components.interfaceOperators.build(operatorList);
  const auto coupling = components.couplings.build({"Type=Monolithic"});
  offerWhole(model_, *coupling, operatorList);
  CondensedModel condensed = condense(model_, *solver, *representation, comm, ledger);
  InterfaceState state;
  if (!model_.interfaces.empty())
    state = coupling
                ->solve(
                    condensed.interface, [](const SweepRecord&, const InterfaceState&) {}, ledger)
                .state;
  for (auto& fields : recoverFields(model_, condensed, {state}, comm, ledger))
    displacement_.push_back(std::move(fields.displacement.front()));
  systems_ = std::move(condensed.systems); // the matrices stay where they are as long as the factors live
}

bool ReferenceSolution::suits(const Model& coarse, int refinements) const
{
  const auto sameRoles = [](const InterfaceMesh& a, const InterfaceMesh& b) {
    return a.dirichlet().body == b.dirichlet().body;
  };
  return refinements == refinements_ && coarse.recipe.sameModel(recipe_) && coarse.recipe.sameSolver(recipe_) &&
         std::equal(coarse.interfaces.begin(), coarse.interfaces.end(), model_.interfaces.begin(),
                    model_.interfaces.end(), sameRoles);
}

std::int64_t ReferenceSolution::dofs() const
{
  return model_.totalDofs();
}

std::vector<NodalField> ReferenceSolution::onFineMesh(const std::vector<NodalField>& displacement) const
{
  std::vector<NodalField> all = displacement;
  for (std::size_t b = 0; b < all.size(); ++b)
    for (std::size_t level = 0; level < coarser_[b].size(); ++level)
      all[b] =
          atNodes(prolongate(coarser_[b][level],
                             level + 1 < coarser_[b].size() ? coarser_[b][level + 1] : model_.bodies[b].nodes, all[b]),
                  all[b].width());
  return all;
}

Vector ReferenceSolution::applyStiffness(std::size_t body, const Vector& displacement) const
{
  const BodySystem& system = systems_[body];
  const NodalField local = system.dofs.frames.toLocal(displacement);
  return system.dofs.frames.toGlobal(multiply(system.K, local, comm_)).whole();
}

double ReferenceSolution::fineNorm(const std::vector<NodalField>& displacement) const
{
  double squared = 0.0;
  for (std::size_t b = 0; b < displacement.size(); ++b)
    squared += dot(displacement[b], applyStiffness(b, displacement[b]));
  return std::sqrt(squared);
}

double ReferenceSolution::norm(const std::vector<NodalField>& displacement) const
{
  return fineNorm(onFineMesh(displacement));
}

double ReferenceSolution::distance(const std::vector<NodalField>& displacement) const
{
  return fineNorm(difference(displacement_, onFineMesh(displacement)));
}

double ReferenceSolution::stressDistance(const Model& coarse, const std::vector<NodalField>& admissible,
                                         const std::vector<ContactPatch>& patches, const ContactTraction& traction,
                                         double D) const
{
  const auto start = onFineMesh(admissible), v = difference(displacement_, start);
  double squared = D * D;
  for (std::size_t b = 0; b < v.size(); ++b) {
    const Vector stiff = applyStiffness(b, v[b]);
    const NodalField load = systems_[b].dofs.frames.toGlobal(systems_[b].load.all());
    squared += dot(v[b], stiff) - 2.0 * (dot(load, v[b]) - dot(start[b], stiff));
  }
  if (!patches.empty()) {
    const auto fine = contactPatches(model_);
    const ContactTraction t = onFinePatches(coarse, patches, traction, model_, fine);
    std::vector<const BodyModel*> bodies;
    for (const auto& body : model_.bodies)
      bodies.push_back(&body);
    for (const double work : contactContributions(fine, t, jumpMoments(bodies, fine, v, t.degree)))
      squared -= work; // twice the work
  }
  return std::sqrt(std::max(0.0, squared));
}

void updateReference(std::shared_ptr<const ReferenceSolution>& reference, const SceneSettings& settings,
                     const CertificateComponents& components, const Model& model, const ReferenceDepth& depth,
                     const Comm& comm, Ledger& ledger)
{
  const int refinements = affordableRefinements(model, depth);
  if (reference && reference->suits(model, refinements)) {
    ledger.count("references reused");
    return;
  }
  reference.reset(); // its memory is needed
  if (refinements > 0)
    reference = std::make_shared<ReferenceSolution>(settings, components, model, refinements, comm);
}

ReferenceSummary compareWithReference(const ReferenceSolution* reference, const Model& model,
                                      const std::vector<NodalField>& displacement, const CertifiedStress* certified,
                                      const ReferenceDepth& depth)
{
  ReferenceSummary summary;
  summary.refinements = reference == nullptr ? 0 : reference->refinements();
  if (summary.refinements < depth.refinements)
    summary.note = fmt::format("{} of {} refinements: the next one would have more than {} dofs", summary.refinements,
                               depth.refinements, affordableDofs(model, depth));
  if (reference == nullptr) {
    summary.displacement = summary.relative = std::numeric_limits<double>::quiet_NaN();
    return summary;
  }
  summary.dofs = reference->dofs();
  summary.displacement = reference->distance(displacement);
  const double size = reference->norm(displacement);
  summary.relative = size > 0.0 ? summary.displacement / size : 0.0;
  if (certified == nullptr)
    return summary;
  const double D = certified->measure.elements, toAdmissible = reference->distance(certified->admissible);
  summary.stress = reference->stressDistance(model, certified->admissible, certified->patches, certified->traction, D);
  // The parallelogram of sigma_ref, sigma^ and K eps(u^).
  summary.meanStress =
      std::sqrt(std::max(0.0, 0.5 * (*summary.stress * *summary.stress + toAdmissible * toAdmissible) - 0.25 * D * D));
  summary.effectivity = ratio(certified->bound, summary.displacement, size);
  summary.meanStressEffectivity = ratio(certified->measure.meanStress(), *summary.meanStress, size);
  return summary;
}

} // namespace ndframe
