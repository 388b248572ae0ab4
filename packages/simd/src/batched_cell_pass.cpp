#include "batched_cell_pass.hpp"

#include <algorithm>

#include "batched_tables.hpp"
#include "batched_workspace.hpp"

namespace ndframe
{
namespace
{

constexpr int edgeValues = 4, nodeValues = 12, stressValues = 9;
constexpr int lawValues = int(sizeof(PlaneLaw) / sizeof(double));

/// From the first vertex to the others; vertices in the order of `local`.
void takeEdges(const Mesh& mesh, int cell, const int* local, int lane, int lanes, double* values)
{
  const int* vertices = mesh.cell(cell);
  const double* origin = mesh.point(vertices[local[0]]);
  for (int a = 0; a < 2; ++a)
    for (int i = 0; i < 2; ++i)
      values[(2 * a + i) * lanes + lane] = mesh.point(vertices[local[a + 1]])[i] - origin[i];
}

/// At the vertices in the order of `local`, then in the middles of the edges opposite to them.
void takeDisplacement(const NodeMap& nodes, const Vector& displacement, int cell, const int* local, int lane, int lanes,
                      double* values)
{
  const int* cellNodes = nodes.cell(cell);
  for (int a = 0; a < 3; ++a) {
    const double* vertex = displacement.data() + std::ptrdiff_t(2) * cellNodes[local[a]];
    const double* one = displacement.data() + std::ptrdiff_t(2) * cellNodes[local[(a + 1) % 3]];
    const double* other = displacement.data() + std::ptrdiff_t(2) * cellNodes[local[(a + 2) % 3]];
    // The edge opposite to local vertex l is number l + 1 of 01, 12, 20.
    const double* middle =
        nodes.order == 2 ? displacement.data() + std::ptrdiff_t(2) * cellNodes[3 + (local[a] + 1) % 3] : nullptr;
    for (int i = 0; i < 2; ++i) {
      values[(2 * a + i) * lanes + lane] = vertex[i];
      values[(6 + 2 * a + i) * lanes + lane] = middle != nullptr ? middle[i] : 0.5 * (one[i] + other[i]);
    }
  }
}

void takeLaw(const PlaneLaw& law, int lane, int lanes, double* values)
{
  for (const auto* part : {&law.compliance, &law.stiffness, &law.root})
    for (const double value : *part) {
      values[lane] = value;
      values += lanes;
    }
}

/// How many values are zero in all lanes before the first that is not: an even number.
int leadingZeros(const double* data, int count, int lanes)
{
  const double* end = data + std::ptrdiff_t(count) * lanes;
  const auto first = std::find_if(data, end, [](double value) { return value != 0.0; }) - data;
  return int(first) / lanes / 2 * 2;
}

} // namespace

Vector vertexStress(const BodyModel& body, const BatchedKernels& kernels, const Vector& displacement)
{
  constexpr int order[3] = {0, 1, 2};
  const auto law = planeLaw(body.laws.all().front());
  const auto several = severalLaws(body.laws);
  const int lanes = kernels.lanes, cells = body.mesh.numCells();
  AlignedDoubles memory(std::size_t(edgeValues + nodeValues + stressValues + lawValues) * std::size_t(lanes));
  CellBatch batch;
  batch.edges = memory.data();
  batch.displacement = batch.edges + std::ptrdiff_t(edgeValues) * lanes;
  batch.stress = batch.displacement + std::ptrdiff_t(nodeValues) * lanes;
  if (!several.empty())
    batch.law = batch.stress + std::ptrdiff_t(stressValues) * lanes;
  Vector stress(std::size_t(stressValues) * std::size_t(cells));
  for (int first = 0; first < cells; first += lanes) {
    const int count = std::min(lanes, cells - first);
    for (int lane = 0; lane < lanes; ++lane) {
      const int cell = first + std::min(lane, count - 1);
      takeEdges(body.mesh, cell, order, lane, lanes, batch.edges);
      takeDisplacement(body.nodes, displacement, cell, order, lane, lanes, batch.displacement);
      if (batch.law != nullptr)
        takeLaw(several[std::size_t(body.laws.number(cell))], lane, lanes, batch.law);
    }
    kernels.vertexStress(law, batch);
    double* out = stress.data() + std::size_t(stressValues) * std::size_t(first);
    for (int lane = 0; lane < count; ++lane)
      for (int i = 0; i < stressValues; ++i)
        *out++ = batch.stress[i * lanes + lane];
  }
  return stress;
}

Vector batchedCellDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference,
                            const BatchedKernels& kernels)
{
  const BatchedCellTables tables(correction.degree, body.laws.all().front());
  const auto several = severalLaws(body.laws);
  const auto distance = kernels.degree[correction.degree - 1].distance;
  const int lanes = kernels.lanes, cells = body.mesh.numCells();
  const int tractions = 6 * (correction.degree + 1), loads = 2 * loadModesOf(correction.degree);
  AlignedDoubles memory(std::size_t(edgeValues + nodeValues + tractions + loads + 1 + lawValues) * std::size_t(lanes));
  CellBatch batch;
  batch.edges = memory.data();
  batch.data = batch.edges + std::ptrdiff_t(edgeValues) * lanes;
  batch.distance = batch.data + std::ptrdiff_t(tractions + loads) * lanes;
  batch.displacement = difference == nullptr ? nullptr : batch.distance + lanes;
  if (!several.empty())
    batch.law = batch.distance + std::ptrdiff_t(1 + nodeValues) * lanes;
  Vector distances(std::size_t(cells), 0.0);
  for (int first = 0; first < cells; first += lanes) {
    const int count = std::min(lanes, cells - first);
    for (int lane = 0; lane < lanes; ++lane) {
      const int cell = first + std::min(lane, count - 1);
      const SortedCell sorted = sortedCell(body.mesh, cell);
      takeEdges(body.mesh, cell, sorted.local.data(), lane, lanes, batch.edges);
      if (difference != nullptr)
        takeDisplacement(body.nodes, *difference, cell, sorted.local.data(), lane, lanes, batch.displacement);
      if (batch.law != nullptr)
        takeLaw(several[std::size_t(body.laws.number(cell))], lane, lanes, batch.law);
      const double* traction = correction.tractions.data() + std::size_t(cell) * std::size_t(tractions);
      for (int i = 0; i < tractions; ++i)
        batch.data[i * lanes + lane] = traction[i];
      const double* load = correction.loads.data() + std::size_t(cell) * std::size_t(loads);
      for (int i = 0; i < loads; ++i)
        batch.data[(tractions + i) * lanes + lane] = load[i];
    }
    batch.firstData = leadingZeros(batch.data, tractions + loads, lanes);
    distance(tables.tables(), batch);
    std::copy_n(batch.distance, count, distances.begin() + first);
  }
  return distances;
}

} // namespace ndframe
