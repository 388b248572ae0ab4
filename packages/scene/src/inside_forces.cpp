#include "inside_forces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/assembly/body_loads.hpp"

namespace ndframe
{
namespace
{

/// The basis of a body that several ranks have.
RigidBasis basisOfAll(const Mesh& part, const Comm& comm)
{
  const std::size_t dim = std::size_t(part.dim);
  Vector low(dim, INFINITY), high(dim, -INFINITY);
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    low[i % dim] = std::min(low[i % dim], part.points[i]);
    high[i % dim] = std::max(high[i % dim], part.points[i]);
  }
  takeExtremes(low, high, comm);
  Mesh corners;
  corners.dim = part.dim;
  corners.points = low;
  corners.points.insert(corners.points.end(), high.begin(), high.end());
  return rigidBasis(corners);
}

/// What the loads on its cells do to a part: per mode their work and its magnitude, and the sum of their absolute
/// values.
Vector workIn(Mesh mesh, std::vector<std::unique_ptr<Load>> loads, int order, const RigidBasis& rigid)
{
  Vector sums(2 * std::size_t(rigid.size()) + 1, 0.0);
  if (mesh.numCells() == 0)
    return sums;
  BodyModel body;
  body.mesh = std::move(mesh);
  body.nodes = makeNodeMap(body.mesh, order);
  body.loads = std::move(loads);
  const NodalField all = integrateLoads(body);
  const auto dim = std::size_t(body.mesh.dim);
  for (int node = 0; node < body.nodes.numNodes(); ++node) {
    Direction force{};
    for (std::size_t k = 0; k < dim; ++k)
      force[k] = all[std::size_t(node) * dim + k];
    for (int mode = 0; mode < rigid.size(); ++mode) {
      const Direction u = rigid.displacement(mode, body.nodes.point(node).data());
      sums[2 * std::size_t(mode)] += dotProduct(force, u);
      sums[2 * std::size_t(mode) + 1] += std::sqrt(dotProduct(force, force) * dotProduct(u, u));
    }
    for (const double component : force)
      sums.back() += std::abs(component);
  }
  return sums;
}

/// The cells whose lowest vertex is this rank's.
NumberedMesh ownCells(const BodyPieces& body, const Comm& comm)
{
  const Mesh& mesh = body.part.mesh;
  return body.part.only([&](int cell) {
    const int* const first = mesh.cell(cell);
    return body.owners[std::size_t(*std::min_element(first, first + mesh.dim + 1))] == comm.rank();
  });
}

/// Those that act on cells.
std::vector<std::unique_ptr<Load>> loadsOnCells(const BodySettings& settings, const SceneComponents& components)
{
  std::vector<std::unique_ptr<Load>> loads;
  for (const Params& list : settings.loads)
    if (!list.has("Side"))
      loads.push_back(components.loads.build(list));
  return loads;
}

/// What workIn() says of this rank's cells, on rank 0 without those that are outer. Throws InputError.
Vector workOfOwn(const BodyPieces& body, const BodySettings& settings, const SceneComponents& components, int order,
                 const RigidBasis& rigid, const Comm& comm)
{
  Diagnostics diagnostics;
  for (const auto& load : loadsOnCells(settings, components))
    load->check(body.part.mesh, diagnostics);
  diagnostics.throwIfAny();
  Vector sums = workIn(ownCells(body, comm).mesh, loadsOnCells(settings, components), order, rigid);
  if (comm.rank() == 0) {
    const Vector outer = workIn(body.outer.mesh, loadsOnCells(settings, components), order, rigid);
    std::transform(sums.begin(), sums.end(), outer.begin(), sums.begin(), std::minus<>());
  }
  return sums;
}

} // namespace

std::optional<ForcesInside> forcesInside(const BodyPieces& body, const BodySettings& settings,
                                         const SceneComponents& components, int order, const Comm& comm)
{
  if (loadsOnCells(settings, components).empty())
    return ForcesInside{};
  const RigidBasis rigid = basisOfAll(body.part.mesh, comm);
  Vector sums(2 * std::size_t(rigid.size()) + 1, 0.0);
  double mistakes = 0.0;
  try {
    sums = workOfOwn(body, settings, components, order, rigid, comm);
  } catch (const InputError&) { // told where the pieces are read as a whole
    mistakes = 1.0;
  }
  sums.push_back(mistakes);
  comm.sum(sums);
  if (sums.back() > 0.0)
    return std::nullopt;
  sums.pop_back();
  ForcesInside forces;
  for (std::size_t mode = 0; mode < std::size_t(rigid.size()); ++mode) {
    forces.work.push_back(sums[2 * mode]);
    forces.magnitude.push_back(std::max(0.0, sums[2 * mode + 1]));
  }
  forces.sum = std::max(0.0, sums.back());
  return forces;
}

} // namespace ndframe
