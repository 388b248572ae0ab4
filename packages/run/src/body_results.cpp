#include "ndframe/run/body_results.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/assembly/fields.hpp"
#include "ndframe/assembly/nodal_stress.hpp"
#include "ndframe/condensation/reactions.hpp"

namespace ndframe
{
namespace
{

std::vector<double> coordinates(const double* point, int dim)
{
  return {point, point + dim};
}

/// Values this close to the largest, relative to it, are equally large: of them the first counts, so that round-off
/// does not choose the place.
constexpr double equallyLarge = 1e-9;

/// The first of the largest values.
std::size_t peakOf(const Vector& values)
{
  const double largest = *std::max_element(values.begin(), values.end());
  const auto first =
      std::find_if(values.begin(), values.end(), [&](double value) { return value >= (1.0 - equallyLarge) * largest; });
  return first == values.end() ? 0 : std::size_t(first - values.begin());
}

PeakSummary largestDisplacement(const NodeMap& nodes, const Vector& displacement)
{
  Vector sizes;
  for (int i = 0; i < nodes.numNodes(); ++i) {
    const double* u = displacement.data() + std::ptrdiff_t(i) * nodes.dim;
    sizes.push_back(std::hypot(u[0], u[1], nodes.dim == 3 ? u[2] : 0.0));
  }
  const std::size_t peak = peakOf(sizes);
  return {sizes[peak], coordinates(nodes.point(int(peak)).data(), nodes.dim)};
}

PeakSummary largestStrain(const BodyModel& body, const Vector& u)
{
  const auto strains = largestStrains(body, u);
  Vector sizes;
  for (const auto& strain : strains)
    sizes.push_back(strain.value);
  const std::size_t peak = peakOf(sizes);
  return {sizes[peak], coordinates(body.mesh.point(strains[peak].vertex), body.mesh.dim)};
}

std::vector<double> resultant(const Vector& nodal, int dim)
{
  std::vector<double> sum(std::size_t(dim), 0.0);
  for (std::size_t i = 0; i < nodal.size(); ++i)
    sum[i % sum.size()] += nodal[i];
  return sum;
}

std::vector<RegionSummary> regionSummaries(const BodyModel& body, const CellValues& energies)
{
  std::vector<RegionSummary> summaries;
  for (const BodyRegion& region : body.regions)
    summaries.push_back({region.name, region.numCells, 0.0});
  for (std::size_t c = 0; c < body.regionOfCell.size(); ++c)
    summaries[std::size_t(body.regionOfCell[c])].energy += energies[c];
  return summaries;
}

} // namespace

void completeBodies(RunSummary& all, const Run& run, const Comm& comm)
{
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const NodalField& local = run.solved.fields[b].u.back();
    const NodalField u = run.condensed.systems[b].dofs.frames.toGlobal(local);
    BodySummary& summary = all.bodies[b];
    const CellValues energies = cellEnergies(body, u);
    summary.energy = std::accumulate(energies.begin(), energies.end(), 0.0);
    summary.regions = regionSummaries(body, energies);
    all.energy += summary.energy;
    summary.loadForce = resultant(run.model.loads[b].all(), body.mesh.dim);
    summary.supports =
        supportReactions(body, supportForces(run.model, run.condensed, run.solved.coupling.state, int(b), local, comm));
    summary.displacement = largestDisplacement(body.nodes, run.solved.fields[b].displacement.back());
    summary.strain = largestStrain(body, u);
  }
}

} // namespace ndframe
