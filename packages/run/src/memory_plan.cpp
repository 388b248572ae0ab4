#include "ndframe/run/memory_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "ndframe/base/grouped.hpp"
#include "ndframe/base/memory.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "shared_run.hpp"

namespace ndframe
{
namespace
{

/// Of the process before it has read anything.
constexpr double atStart = 30e6;

/// A dof of a solid with its matrix, two levels and what is beside them, on one rank.
constexpr double multigridBytes = 1500.0;

/// The same on several ranks, of a dof that is the rank's own and of any dof of the scene; libraries and MPI.
constexpr double ownBytes = 1300.0, replicatedBytes = 45.0, atStartOfRanks = 1e8;

/// A dof of a rank's share of a mesh that ranks refine, with the ghosts of a rank inside; with a bound of the error.
constexpr double shareBytes = 1500.0, certifiedShareBytes = 2600.0;

/// A dof of a solid whose error is bounded, on one rank; on several, of a rank's own and of any.
constexpr double certifiedBytes = 2400.0, ownCertifiedBytes = 2000.0, replicatedCertifiedBytes = 120.0;

bool isDirect(const RunSettings& settings)
{
  return settings.linearSolver != "Krylov" && settings.linearSolver != "Multigrid";
}

/// Dofs of a box, from its bricks with their Refine: vertices and edges of large grids. Nothing for other meshes.
std::optional<double> dofsOfBox(const Params& mesh, int order)
{
  if (mesh.get<std::string>("Type") != "Box")
    return std::nullopt;
  const auto cells = mesh.get<std::vector<int>>("Cells");
  const double parts = std::exp2(halvingsOf(mesh) * double(cells.size())); // of a brick
  const double bricks = std::accumulate(cells.begin(), cells.end(), parts, std::multiplies<double>());
  if (cells.size() == 3)
    return 3.0 * bricks * (order == 1 ? 1.0 : 8.0);
  const double vertices = mesh.get<std::string>("Pattern") == "Crossed" ? 2.0 : 1.0;
  return 2.0 * bricks * vertices * (order == 1 ? 1.0 : 4.0);
}

/// Whether these solids, in contact if they are several, are solved without a factor.
bool takesMultigrid(const RunSettings& settings, const LinearSolver& solver, bool solvesWhole, double dofs, int ranks)
{
  BodyOutline all{3, std::int64_t(dofs), 0, false, 0.0};
  for (const BodySettings& body : settings.scene.bodies) {
    all.bodies += !body.isRigid;
    if (body.material && body.material->has("Poisson Ratio"))
      all.poissonRatio = std::max(all.poissonRatio, body.material->get<double>("Poisson Ratio"));
  }
  all.isCondensed = all.bodies > 1 && !solvesWhole;
  return solver.name(all, ranks) == "Multigrid";
}

/// Of the stored Schur complements and their factors: three matrices a body.
double memoryOfInterfaces(const Model& model, const Params& representation)
{
  constexpr auto limit = "Largest Condensed"; // where the deck leaves the choice
  const bool isStored = representation.get<std::string>("Type") == "Condensed";
  std::vector<double> sizes(model.bodies.size(), 0.0);
  for (const InterfaceMesh& interface : model.interfaces)
    for (const int body : {interface.dirichlet().body, interface.neumann().body})
      sizes[std::size_t(body)] += interface.numNodes();
  double bytes = 0.0;
  for (const double size : sizes)
    if (isStored || (representation.has(limit) && size <= representation.get<int>(limit)))
      bytes += 3.0 * 8.0 * size * size;
  return bytes;
}

} // namespace

double memoryOfBody(double dofs, int dim)
{
  if (dofs < 2.0)
    return 0.0;
  return dim == 2 ? dofs * (45.0 + 75.0 * std::log2(dofs)) : 200.0 * std::pow(dofs, 4.0 / 3.0);
}

double memoryOfRank(double dofs, int ranks)
{
  return atStartOfRanks + (ranks == 1 ? ownBytes : ownBytes / ranks + replicatedBytes) * dofs;
}

double memoryOfCertificate(double dofs, int ranks)
{
  return ranks == 1 ? certifiedBytes * dofs
                    : atStartOfRanks + (ownCertifiedBytes / ranks + replicatedCertifiedBytes) * dofs;
}

std::string memoryPlan(const RunSettings& settings, const LinearSolver& solver, bool solvesWhole, int ranks)
{
  const std::string left = fmt::format("{} left", memoryLeft().text());
  const bool namesMultigrid = settings.linearSolver == "Multigrid";
  if (!isDirect(settings) && !namesMultigrid)
    return fmt::format("not estimated for {}; {}", settings.linearSolver, left);
  double bytes = atStart, dofs = 0.0;
  bool areSolids = true;
  for (const BodySettings& body : settings.scene.bodies) {
    if (body.isRigid)
      continue;
    const auto ofBox = dofsOfBox(body.shape, settings.scene.order);
    if (!ofBox)
      return fmt::format("checked when the mesh files are read; {}", left);
    const int dim = int(body.shape.get<std::vector<int>>("Cells").size());
    dofs += *ofBox;
    bytes += memoryOfBody(*ofBox, dim);
    areSolids = areSolids && dim == 3;
  }
  if (namesMultigrid && !areSolids)
    return fmt::format("not estimated for {} in the plane; {}", settings.linearSolver, left);
  const bool isMultigrid = areSolids && takesMultigrid(settings, solver, solvesWhole, dofs, ranks);
  const bool certifies = settings.errors && !settings.errors->estimators.empty();
  if (isMultigrid && solvesWhole && mayBeShared(settings, ranks))
    bytes = atStartOfRanks + (certifies ? certifiedShareBytes : shareBytes) * dofs / ranks;
  else if (isMultigrid)
    bytes = std::max(memoryOfRank(dofs, ranks), certifies ? memoryOfCertificate(dofs, ranks) : 0.0);
  return fmt::format("about {:.2g} GB{} for some {} dofs; {}{}", 1e-9 * bytes,
                     isMultigrid && ranks > 1 ? fmt::format(" on each of {} ranks", ranks) : "",
                     grouped(std::int64_t(dofs)), left, bytes > double(memoryLeft().bytes) ? ": NOT ENOUGH" : "");
}

void checkMemory(const Model& model, const RunSettings& settings, const LinearSolver& solver, int ranks,
                 const Comm& having, Diagnostics& diagnostics)
{
  double ofInterfaces = memoryOfInterfaces(model, settings.scene.interfaceOperator);
  double bytes = ofInterfaces;
  bool areCondensed = false;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyOutline body = model.outline(int(b));
    const double dofs = model.bodies[b].numDofs();
    const bool iterates = solver.name(body, ranks) == "Multigrid"; // chosen by Automatic
    bytes += iterates ? multigridBytes * dofs * having.size() / ranks : memoryOfBody(dofs, body.dim);
    areCondensed = areCondensed || !iterates;
  }
  if (!areCondensed)
    bytes -= std::exchange(ofInterfaces, 0.0);
  const MemoryLeft left = memoryLeft();
  const bool isTooLarge = isDirect(settings) && 0.5 * bytes > double(left.bytes);
  if (having.sum(std::int64_t(isTooLarge)) == 0)
    return;
  const bool isInterface = ofInterfaces > 0.5 * bytes;
  diagnostics.add(settings.scene.bodiesPlace.mistake(
      "",
      fmt::format("{} dofs need about {:.2g} GB of memory{}, and {} are available: use {}.", grouped(model.totalDofs()),
                  1e-9 * bytes, isInterface ? ", most of it for stored interface operators" : "", left.text(),
                  isInterface ? "Interface Operator/Type = Matrix Free or a coarser interface"
                              : "coarser meshes, order 1, or Multigrid as linear solver")));
}

} // namespace ndframe
