#include "ndframe/run/memory_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
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
constexpr double shareBytes = 1500.0, certifiedShareBytes = 2100.0;

/// A dof of a solid whose error is bounded, on one rank; on several, of a rank's own and of any. Of cells that are all
/// different; others take as little as without a bound.
constexpr double certifiedBytes = 2000.0, ownCertifiedBytes = 1700.0, replicatedCertifiedBytes = 120.0;

bool isDirect(const RunSettings& settings)
{
  return settings.linearSolver != "Krylov" && settings.linearSolver != "Multigrid";
}

/// What a mesh will have.
struct MeshSize
{
  double dofs = 0.0, cells = 0.0;
};

/// How a box cuts its bricks: into how many cells, and how many vertices, and vertices and middles of edges, each has
/// beyond those of a grid, and of one of half the width.
struct BrickPattern
{
  std::string_view name;
  std::size_t dim;
  double cells, vertices, nodes;
};

constexpr std::array<BrickPattern, 5> brickPatterns{{{"Right", 2, 2.0, 0.0, 0.0},
                                                     {"Alternating", 2, 2.0, 0.0, 0.0},
                                                     {"Crossed", 2, 4.0, 1.0, 4.0},
                                                     {"Right", 3, 6.0, 0.0, 0.0},
                                                     {"Alternating", 3, 5.0, 0.0, -1.0}}};

/// Of a box, from its bricks with their Refine. Nothing for other meshes.
std::optional<MeshSize> sizeOfBox(const Params& mesh, int order)
{
  if (mesh.get<std::string>("Type") != "Box")
    return std::nullopt;
  const auto counts = mesh.get<std::vector<int>>("Cells");
  const auto name = mesh.get<std::string>("Pattern");
  const auto pattern = std::find_if(brickPatterns.begin(), brickPatterns.end(), [&](const BrickPattern& one) {
    return one.name == name && one.dim == counts.size();
  });
  if (pattern == brickPatterns.end()) // refused where it is read
    return std::nullopt;
  double bricks = 1.0, vertices = 1.0, nodes = 1.0;
  for (const int count : counts) {
    const double along = std::ldexp(count, halvingsOf(mesh));
    bricks *= along;
    vertices *= along + 1.0;
    nodes *= 2.0 * along + 1.0;
  }
  vertices += pattern->vertices * bricks;
  nodes += pattern->nodes * bricks;
  return MeshSize{double(counts.size()) * (order == 1 ? vertices : nodes), pattern->cells * bricks};
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

/// Bytes of each of so many ranks that solve these solids by Multigrid.
double bytesOfRank(const RunSettings& settings, double dofs, bool solvesWhole, int ranks)
{
  const bool certifies = settings.errors && !settings.errors->estimators.empty();
  if (solvesWhole && mayBeShared(settings, ranks))
    return atStartOfRanks + (certifies ? certifiedShareBytes : shareBytes) * dofs / ranks;
  return std::max(memoryOfRank(dofs, ranks), certifies ? memoryOfCertificate(dofs, ranks) : 0.0);
}

/// How many machines like this one, with a rank each, have the memory; 0: more than can be counted on.
int machinesFor(const RunSettings& settings, double dofs, bool solvesWhole)
{
  constexpr int most = 100'000;
  const auto left = double(memoryLeft().bytes);
  int machines = 1;
  while (machines <= most && bytesOfRank(settings, dofs, solvesWhole, machines) > left)
    machines += std::max(1, machines / 20);
  return machines <= most ? machines : 0;
}

std::string gigabytes(double bytes)
{
  constexpr double many = 1e11;
  const double size = 1e-9 * bytes;
  return bytes < many ? fmt::format("{:.2g} GB", size) : grouped(std::int64_t(size)) + " GB";
}

/// "about ... GB on each of 4 ranks for some ... dofs in ... tetrahedra, ... and ... for a rank; ... left".
std::string sharedPlan(const RunSettings& settings, const MeshSize& all, bool solvesWhole, int ranks)
{
  const double bytes = bytesOfRank(settings, all.dofs, solvesWhole, ranks);
  const MemoryLeft left = memoryLeft();
  const auto counted = [](double count) { return grouped(std::int64_t(count)); };
  std::string text = fmt::format("about {}{} for some {} dofs", gigabytes(bytes),
                                 ranks > 1 ? fmt::format(" on each of {} ranks", ranks) : "", counted(all.dofs));
  if (ranks > 1)
    text += fmt::format(" in {} tetrahedra, some {} and {} for a rank", counted(all.cells), counted(all.dofs / ranks),
                        counted(all.cells / ranks));
  text += fmt::format("; {} left", left.text());
  if (bytes * ranks <= double(left.bytes))
    return text;
  text += ranks > 1 ? ": NOT ENOUGH for all of them on one machine" : ": NOT ENOUGH";
  const int machines = machinesFor(settings, all.dofs, solvesWhole);
  return machines > 1 ? text + fmt::format("; {} machines like this one, with a process each, would do", machines)
                      : text;
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
  double factors = atStart;
  MeshSize all;
  bool areSolids = true;
  for (const BodySettings& body : settings.scene.bodies) {
    if (body.isRigid)
      continue;
    const auto box = sizeOfBox(body.shape, settings.scene.order);
    if (!box)
      return fmt::format("checked when the mesh files are read; {}", left);
    const int dim = int(body.shape.get<std::vector<int>>("Cells").size());
    all.dofs += box->dofs;
    all.cells += box->cells;
    factors += memoryOfBody(box->dofs, dim);
    areSolids = areSolids && dim == 3;
  }
  if (namesMultigrid && !areSolids)
    return fmt::format("not estimated for {} in the plane; {}", settings.linearSolver, left);
  if (!areSolids || !takesMultigrid(settings, solver, solvesWhole, all.dofs, ranks))
    return fmt::format("about {} for some {} dofs; {}{}", gigabytes(factors), grouped(std::int64_t(all.dofs)), left,
                       factors > double(memoryLeft().bytes) ? ": NOT ENOUGH" : "");
  return sharedPlan(settings, all, solvesWhole, ranks);
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
