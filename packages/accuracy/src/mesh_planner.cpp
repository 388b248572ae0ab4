#include "ndframe/accuracy/mesh_planner.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ndframe/algebra/dense.hpp"
#include "places.hpp"

namespace ndframe
{
namespace
{

// Chosen where `punch` and `contact-loss` need the fewest dofs in all for 2 % to 0.1 % (docs/accuracy.md).

/// The bound of a mesh is to be at least this part of the one before. With more there are more levels, with less
/// predictions do not reach that far. In space a mesh with 0.45 times the bound has 4 to 6 times the dofs, and one that
/// is made anew was found to have a bound 0.85 times what was expected there.
double largestFall(int dim, bool isMadeAnew)
{
  if (dim == 2)
    return 0.22;
  return isMadeAnew ? 0.5 : 0.45;
}
/// In space the last step may be longer than those that others begin from, once the bound is below a tenth: before
/// that predictions do not reach so far, and a miss costs as much as the two steps that it saves (docs/accuracy.md).
constexpr double lastFall = 0.42, foreseen = 0.1;
/// The last step aims below the target: predictions are off by some per cent, and a miss costs one more mesh.
double aimAtTarget(int dim)
{
  return dim == 2 ? 0.92 : 0.94;
}
/// A level is worth its work if the bound falls to this part at least.
constexpr double smallestFall = 0.94;
/// Where Maximum Dofs decides about the meshes, they are made again for at least such a fall.
constexpr double worthwhile = 0.9;
/// What became of the last plan corrects the next one, but only where it came out better: a bound that is worse may be
/// a spike where contact ends on this mesh.
constexpr double leastCorrection = 0.95;

/// With a larger relative bound nothing can be learned about corners and edges: cells are larger than what they shall
/// show. Of edges there is a lot, and meshes in space are coarser.
double tooCoarse(int dim)
{
  return dim == 2 ? 0.3 : 0.5;
}

/// Where a frictionless contact ends inside a smooth side, u ~ r^1.5. It ends up to half a facet away from the vertex
/// that meshes are graded to, and the traction's part of the bound is largest there: a smaller exponent, with smaller
/// cells, needs fewer dofs and levels in all and brackets the end more closely.
constexpr double whereContactEnds = 1.1;

/// On a mesh with a relative bound of 1 % the end of contact shall be known within 3 % of its interface's length.
constexpr double bracketPerBound = 3.0;

/// The end may leave its bracket on the next mesh: as far beyond either end of it, in its widths, facets are short,
/// too.
constexpr double besides = 0.5;

/// Plans are made again until they expect what is wanted and not more than this above it; conformity adds cells that a
/// marking does not know of.
constexpr double closeEnough = 0.01;
int mostTrials(int dim)
{
  return dim == 2 ? 4 : 8; // in space conformity adds more, and meshes cost little beside their certificates
}

std::vector<Mesh> meshesOf(const Model& model)
{
  std::vector<Mesh> meshes;
  for (const int b : model.elasticBodies())
    meshes.push_back(model.bodies[std::size_t(b)].uncut());
  return meshes;
}

/// The facet of the uncut mesh in whose plane a facet lies.
Facet uncutFacet(const BodyModel& body, Facet facet)
{
  if (body.parents.empty())
    return facet;
  const auto centre = facetCentre(body.mesh, facet);
  Facet nearest{body.parents[std::size_t(facet.cell)], 0};
  double least = HUGE_VAL;
  for (int local = 0; local <= body.base.dim; ++local) {
    const Facet own{nearest.cell, local};
    const auto middle = facetCentre(body.base, own);
    double normal[3], apart = 0.0;
    facetNormal(body.base, own, normal);
    for (int k = 0; k < body.base.dim; ++k)
      apart += normal[k] * (centre[std::size_t(k)] - middle[std::size_t(k)]);
    if (std::abs(apart) < least) {
      least = std::abs(apart);
      nearest.local = local;
    }
  }
  return nearest;
}

/// Sides that match go on matching; where they do not, each body is refined by itself.
std::vector<FacetTwin> twinsOf(const Model& model)
{
  std::vector<FacetTwin> twins;
  const std::vector<int> place = placesOf(model);
  std::set<std::array<int, 3>> known; // several parts may be of one facet
  for (const auto& interface : model.interfaces) {
    if (interface.isCut || model.bodies[std::size_t(interface.neumann().body)].isRigid)
      continue;
    const int first = interface.dirichlet().body, second = interface.neumann().body;
    for (std::size_t f = 0; f < interface.dirichlet().facets.size(); ++f) {
      const Facet ours = uncutFacet(model.bodies[std::size_t(first)], interface.dirichlet().facets[f]);
      if (known.insert({first, ours.cell, ours.local}).second)
        twins.push_back({place[std::size_t(first)], ours, place[std::size_t(second)],
                         uncutFacet(model.bodies[std::size_t(second)], interface.neumann().facets[f])});
    }
  }
  return twins;
}

/// Vertices - edges + cells of a plane mesh.
std::int64_t eulerNumber(const Mesh& mesh)
{
  return 2 * std::int64_t(mesh.numPoints()) + mesh.numCells() - makeNodeMap(mesh, 2).numNodes();
}

} // namespace

MeshPlanner::MeshPlanner(const RunSettings& settings, const AccuracyComponents& components, const Model& model,
                         const Comm& comm)
    : degree_(model.bodies.front().nodes.order), dim_(model.bodies.front().mesh.dim), fall_(dim_, degree_),
      marking_(components.markings.build(settings.accuracy->lists.marking)), corners_(degree_), edges_(degree_)
{
  const auto refinement = components.refinements.build(settings.accuracy->lists.refinement);
  FirstMeshes first{meshesOf(model), twinsOf(model), {}};
  for (const BodySettings& body : settings.scene.bodies)
    if (!body.isRigid)
      first.sources.push_back(components.meshSources.build(body.shape));
  for (const Mesh& mesh : first.meshes)
    eulers_.push_back(dim_ == 2 ? eulerNumber(mesh) : 0);
  present_ = refinement->begin(std::move(first), comm);
  if (makesSolidsAnew()) {
    edges_ = EdgeExponents(degree_, EdgeExponents::Meshes::MadeAnew);
    fall_.meshesAreMadeAnew();
  }
}

std::int64_t MeshPlanner::dofsOf(const std::vector<Mesh>& meshes) const
{
  std::int64_t nodes = 0;
  for (std::size_t b = 0; b < meshes.size(); ++b)
    if (degree_ == 1)
      nodes += meshes[b].numPoints();
    else
      nodes += dim_ == 2 ? 2 * std::int64_t(meshes[b].numPoints()) + meshes[b].numCells() - eulers_[b]
                         : makeNodeMap(meshes[b], degree_).numNodes();
  return dim_ * nodes;
}

void MeshPlanner::learn(const std::vector<const Mesh*>& uncut, const LevelLesson& lesson)
{
  const LevelErrors errors(lesson.errors);
  double squared = 0.0;
  for (const Vector& eta : lesson.contributions)
    squared += dot(eta, eta);
  if (expected_ > 0.0 && dim_ == 2)
    correction_ = std::clamp(errors.bound / expected_, leastCorrection, 1.0);

  if (expected_ > 0.0 && tells_)
    fall_.learn(bound_, predicted_, errors.bound);
  learnExponents(uncut, lesson.contributions, errors.relative > tooCoarse(dim_));
  contributions_.emplace(meshes(), lesson.contributions, exponentsFor(lesson), degree_, edges_.directions(),
                         makesSolidsAnew());
  brackets_ = lesson.brackets;
  relative_ = errors.relative;
  bound_ = errors.bound;
  tells_ = errors.tells();
  target_ = errors.target;
  total_ = std::sqrt(squared);
}

void MeshPlanner::learnExponents(const std::vector<const Mesh*>& meshes, const std::vector<Vector>& eta, bool isCoarse)
{
  if (dim_ == 3) {
    const bool knewEdges = edges_.knowsAny();
    edges_.observe(meshes, eta, isCoarse);
    if (!knewEdges && edges_.knowsAny())
      fall_.edgesBecameKnown();
    return;
  }
  if (isCoarse)
    corners_ = CornerExponents(degree_);
  corners_.observe(meshes, eta);
}

std::vector<Vector> MeshPlanner::exponentsFor(const LevelLesson& lesson) const
{
  std::vector<Vector> exponents = dim_ == 3 ? edges_.exponents() : corners_.exponents();
  for (const auto& [body, vertex] : lesson.ends) {
    double& exponent = exponents[std::size_t(body)][std::size_t(vertex)];
    exponent = std::min(exponent, whereContactEnds);
  }
  return exponents;
}

std::optional<std::int64_t> MeshPlanner::dofsToTarget() const
{
  const auto cells = marking_->cellsFor(*contributions_, fall_.predicted(bound_, target_) / boundPerTotal());
  if (!cells)
    return std::nullopt;
  double present = 0.0;
  for (const auto& body : contributions_->cells())
    present += double(body.size());
  return std::int64_t(double(dofsOf(meshes())) / present * double(*cells));
}

std::vector<MeshPlanner::FineCell> MeshPlanner::cellsOfBrackets(double width) const
{
  std::vector<FineCell> cells;
  for (const EndOnSide& end : brackets_) {
    FineSegment segment{{}, {}, degree_ * width * end.length};
    for (std::size_t k = 0; k < 2; ++k) {
      const double closed = end.bracket.closed[k], open = end.bracket.open[k];
      segment.from[k] = closed - besides * (open - closed);
      segment.to[k] = open + besides * (open - closed);
    }
    for (std::size_t b = 0; b < meshes().size(); ++b)
      for (int c = 0; c < meshes()[b].numCells(); ++c)
        if (segment.facetOn(meshes()[b], c) > segment.longest)
          cells.push_back({b, std::size_t(c), segment});
  }
  return cells;
}

/// The conformity of meshes is paid for, so it counts: aims again until the meshes with all their cells fit, and keeps
/// the smallest that do.
MeshPlan MeshPlanner::planFor(double wanted) const
{
  const double most = (1.0 + closeEnough) * wanted, least = (1.0 - present_->slack()) * wanted;
  const std::int64_t presentDofs = dofsOf(present_->meshes());
  const std::vector<FineCell> fine = cellsOfBrackets(bracketPerBound * relative_ * wanted / bound_);
  MeshPlan plan;
  std::int64_t lastDofs = 0;
  double fits = 0.0, misses = 0.0; // the last aims that did
  double aim = std::min(fall_.predicted(bound_, wanted) / boundPerTotal(), (smallestFall - present_->slack()) * total_);
  for (int trial = 0; trial < mostTrials(dim_); ++trial) {
    SizeField sizes = marking_->sizes(*contributions_, aim);
    for (const FineCell& cell : fine)
      sizes[cell.body][cell.cell].fine.push_back(cell.segment);
    auto meshes = present_->refined(sizes);
    const std::int64_t dofs = dofsOf(meshes->meshes());
    const double predicted = contributions_->errorOn(meshes->meshes(), meshes->ancestors()) * boundPerTotal();
    const double expected = fall_.expected(bound_, predicted);
    if (trial > 0 && (dofs == lastDofs || dofs == presentDofs))
      break; // the marking does not aim, or not so finely
    const bool better = expected <= most ? plan.bound > most || dofs < plan.dofs : expected < plan.bound;
    if (trial == 0 || better)
      plan = {std::move(meshes), dofs, expected, predicted};
    if (expected <= most && expected >= least)
      break;
    lastDofs = dofs;
    (expected <= most ? fits : misses) = aim;
    const bool isBracketed = dim_ == 3 && fits > 0.0 && misses > 0.0;
    aim = isBracketed ? std::sqrt(fits * misses) : aim * std::pow(wanted / expected, 1.0 / fall_.power());
  }
  return plan;
}

MeshPlan MeshPlanner::nextStep(std::int64_t maximumDofs) const
{
  const double way = aimAtTarget(dim_) * target_ / bound_;
  const double fall = largestFall(dim_, makesSolidsAnew());
  const bool mayBeLonger = dim_ == 3 && !makesSolidsAnew() && relative_ <= foreseen;
  const double steps = way >= (mayBeLonger ? lastFall : fall) ? 1.0 : std::ceil(std::log(way) / std::log(fall));
  double wanted = bound_ * std::min(smallestFall, std::pow(way, 1.0 / steps));
  MeshPlan plan = planFor(wanted);
  const double most = worthwhile * bound_;
  while (plan.dofs > maximumDofs && wanted < most) { // dofs ~ bound^(-dim / p) on the best meshes
    wanted *= std::max(1.02, std::pow(double(plan.dofs) / double(maximumDofs), double(degree_) / dim_));
    wanted = std::min(wanted, most);
    plan = planFor(wanted);
  }
  return plan;
}

void MeshPlanner::accept(MeshPlan plan)
{
  present_ = std::move(plan.meshes);
  expected_ = plan.bound;
  predicted_ = plan.predicted;
}

} // namespace ndframe
