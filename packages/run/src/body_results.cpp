#include "ndframe/run/body_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "ndframe/algebra/shared_values.hpp"
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

/// Of values of all ranks, each of which has its own, the largest: of equally large ones that with the least
/// coordinates, whatever the shares are.
template <class PointOf>
PeakSummary peakOfRanks(const Vector& values, int dim, const PointOf& pointOf, const Comm& comm)
{
  Vector largest{0.0};
  for (const double value : values)
    largest[0] = std::max(largest[0], value);
  takeLargest(largest, comm);
  std::optional<std::pair<std::vector<double>, double>> best; // coordinates and value
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] >= (1.0 - equallyLarge) * largest[0])
      if (auto point = pointOf(i); !best || point < best->first)
        best.emplace(std::move(point), values[i]);
  Vector own;
  if (best) {
    own = best->first;
    own.push_back(best->second);
  }
  const Vector all = gatheredFrom(own, comm);
  if (all.empty()) // none is a number
    return {std::numeric_limits<double>::quiet_NaN(), std::vector<double>(std::size_t(dim), 0.0)};
  std::vector<Vector> peaks;
  for (auto next = all.begin(); next != all.end(); next += dim + 1)
    peaks.emplace_back(next, next + dim + 1);
  const Vector peak = *std::min_element(peaks.begin(), peaks.end());
  return {peak.back(), {peak.begin(), peak.end() - 1}};
}

PeakSummary largestDisplacement(const BodyModel& body, const Vector& displacement, const Comm& comm)
{
  const NodeMap& nodes = body.nodes;
  Vector sizes;
  for (int i = 0; i < nodes.numNodes(); ++i) {
    const double* u = displacement.data() + std::ptrdiff_t(i) * nodes.dim;
    sizes.push_back(std::hypot(u[0], u[1], nodes.dim == 3 ? u[2] : 0.0));
  }
  const auto pointOf = [&](std::size_t node) { return coordinates(nodes.point(int(node)).data(), nodes.dim); };
  if (body.share)
    return peakOfRanks(sizes, body.mesh.dim, pointOf, comm);
  const std::size_t peak = peakOf(sizes);
  return {sizes[peak], pointOf(peak)};
}

/// The part of a body's cells that this rank looks at.
CellRange ownRange(const BodyModel& body, const Comm& comm)
{
  if (body.share)
    return {0, body.share->numOwnCells()};
  const auto from = [&](int rank) { return int(std::int64_t(body.mesh.numCells()) * rank / comm.size()); };
  return {from(comm.rank()), from(comm.rank() + 1)};
}

/// `values` of this rank after those of the ranks before it, and before those of the others.
Vector ofAllRanks(const Vector& values, const Comm& comm)
{
  Vector all(values.size() * std::size_t(comm.size()), 0.0);
  std::copy(values.begin(), values.end(), all.begin() + std::ptrdiff_t(values.size()) * comm.rank());
  comm.sum(all);
  return all;
}

/// The same whatever the number of ranks: of equally large strains that of the first cell.
PeakSummary largestStrain(const BodyModel& body, const std::vector<CellStrain>& strains, const Comm& comm)
{
  Vector sizes;
  for (const auto& strain : strains)
    sizes.push_back(strain.value);
  if (body.share) {
    const auto pointOf = [&](std::size_t cell) {
      return coordinates(body.mesh.point(strains[cell].vertex), body.mesh.dim);
    };
    return peakOfRanks(sizes, body.mesh.dim, pointOf, comm);
  }
  sizes.push_back(0.0); // a rank may look at none
  const Vector largest = ofAllRanks({*std::max_element(sizes.begin(), sizes.end())}, comm);
  const double least = (1.0 - equallyLarge) * *std::max_element(largest.begin(), largest.end());
  const auto own = std::find_if(strains.begin(), strains.end(), [&](const auto& s) { return s.value >= least; });
  const bool has = own != strains.end();
  const Vector all = ofAllRanks({has ? 1.0 : 0.0, has ? own->value : 0.0, has ? double(own->vertex) : 0.0}, comm);
  std::size_t rank = 0;
  while (all[3 * rank] == 0.0 && rank + 1 < largest.size())
    ++rank;
  return {all[3 * rank + 1], coordinates(body.mesh.point(int(all[3 * rank + 2])), body.mesh.dim)};
}

/// Fills in what cells say: energies and strains.
void completeCells(BodySummary& summary, const BodyModel& body, const Vector& u, double strainLimit, const Comm& comm)
{
  const CellRange own = ownRange(body, comm);
  const Vector energies = cellEnergies(body, u, own);
  const std::vector<CellStrain> strains = largestStrains(body, u, own);
  Vector sums(3 + body.regions.size(), 0.0); // energy, measure, that of strained cells, energies of the regions
  for (int c = own.first; c < own.last; ++c) {
    const auto i = std::size_t(c - own.first);
    const double measure = cellMeasure(body.mesh, c);
    sums[0] += energies[i];
    sums[1] += measure;
    if (strains[i].value > strainLimit)
      sums[2] += measure;
    if (!body.regions.empty())
      sums[3 + std::size_t(body.regionOfCell[std::size_t(c)])] += energies[i];
  }
  comm.sum(sums);
  summary.energy = sums[0];
  summary.strainedShare = sums[2] / sums[1];
  summary.regions.clear();
  for (std::size_t r = 0; r < body.regions.size(); ++r)
    summary.regions.push_back({body.regions[r].name, body.regions[r].numCells, sums[3 + r]});
  summary.strain = largestStrain(body, strains, comm);
}

std::vector<double> resultant(const Vector& nodal, int dim)
{
  std::vector<double> sum(std::size_t(dim), 0.0);
  for (std::size_t i = 0; i < nodal.size(); ++i)
    sum[i % sum.size()] += nodal[i];
  return sum;
}

} // namespace

void completeBodies(RunSummary& all, const Run& run, double strainLimit, const Comm& comm)
{
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const NodalField& local = run.solved.fields[b].u.back();
    const NodalField u = run.condensed.systems[b].dofs.frames.toGlobal(local);
    BodySummary& summary = all.bodies[b];
    completeCells(summary, body, u, strainLimit, comm);
    all.energy += summary.energy;
    summary.loadForce = resultant(run.model.loads[b].all(), body.mesh.dim);
    if (body.share)
      comm.sum(summary.loadForce);
    summary.supports = supportReactions(
        body, supportForces(run.model, run.condensed, run.solved.coupling.state, int(b), run.solved.fields[b]), comm);
    summary.displacement = largestDisplacement(body, run.solved.fields[b].displacement.back(), comm);
  }
}

} // namespace ndframe
