#include "ndframe/assembly/body_system.hpp"

#include <algorithm>

#include "ndframe/assembly/body_loads.hpp"
#include "ndframe/mechanics/kernels.hpp"
#include "sparsity.hpp"

namespace ndframe
{
namespace
{

/// Turns the dofs of one node of an element matrix into the node's own axes: rows and columns of that node.
void turnElementNode(double* K, int dofs, int dim, int a, const double* axes)
{
  double turned[3];
  for (int j = 0; j < dofs; ++j) {
    for (int k = 0; k < dim; ++k) {
      turned[k] = 0.0;
      for (int i = 0; i < dim; ++i)
        turned[k] += axes[k * dim + i] * K[(a * dim + i) * dofs + j];
    }
    for (int k = 0; k < dim; ++k)
      K[(a * dim + k) * dofs + j] = turned[k];
  }
  for (int row = 0; row < dofs; ++row) {
    for (int k = 0; k < dim; ++k) {
      turned[k] = 0.0;
      for (int i = 0; i < dim; ++i)
        turned[k] += axes[k * dim + i] * K[row * dofs + a * dim + i];
    }
    for (int k = 0; k < dim; ++k)
      K[row * dofs + a * dim + k] = turned[k];
  }
}

/// Adds an element matrix to the rows that this rank owns. local: per node its number on this rank, or -1.
void scatter(BlockMatrix& K, const int* nodes, int nodesPerCell, const std::vector<int>& local, const double* element)
{
  const int dim = K.dim, dofs = nodesPerCell * dim;
  for (int a = 0; a < nodesPerCell; ++a) {
    const int row = local[std::size_t(nodes[a])];
    if (!K.nodes.owns(row))
      continue;
    for (int b = 0; b < nodesPerCell; ++b) {
      double* block = K.block(row, local[std::size_t(nodes[b])]);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          block[i * dim + j] += element[(a * dim + i) * dofs + b * dim + j];
    }
  }
}

template <int dim, int order>
void addCells(BlockMatrix& K, const BodyModel& body, const Frames& frames, const std::vector<int>& local)
{
  constexpr int nodesPerCell = Lagrange<dim, order>::nodes, dofs = nodesPerCell * dim;
  const QuadratureRule rule = simplexRule(dim, 2 * (order - 1));
  double points[(dim + 1) * dim], element[dofs * dofs];
  for (int c = 0; c < body.mesh.numCells(); ++c) {
    const int* nodes = body.nodes.cell(c);
    if (std::none_of(nodes, nodes + nodesPerCell, [&](int node) { return K.nodes.owns(local[std::size_t(node)]); }))
      continue;
    cellPoints(body.mesh, c, points);
    elementStiffness<dim, order>(points, body.laws(c), rule, element);
    if (frames.anyTurned())
      for (int a = 0; a < nodesPerCell; ++a)
        if (frames.isTurned(nodes[a]))
          turnElementNode(element, dofs, dim, a, frames.axes(nodes[a]));
    scatter(K, nodes, nodesPerCell, local, element);
  }
}

} // namespace

NodalField assembleLoad(const BodyModel& body, const Frames& frames)
{
  return frames.toLocal(integrateLoads(body));
}

SparseField inOwnAxes(const SparseField& global, const Frames& frames)
{
  return frames.anyTurned() ? SparseField(frames.toLocal(global.all())) : global;
}

BodySystem assembleBody(const BodyModel& body, DofLayout dofs, const std::vector<int>& ownedNodes)
{
  return assembleBody(body, std::move(dofs), ownedNodes, SparseField(integrateLoads(body)));
}

BodySystem assembleBody(const BodyModel& body, DofLayout dofs, const std::vector<int>& ownedNodes,
                        const SparseField& load)
{
  BodySystem system{std::move(dofs), makeSparsity(body.nodes, ownedNodes), {}};
  std::vector<int> local(std::size_t(body.nodes.numNodes()), -1);
  for (int i = 0; i < system.K.nodes.size(); ++i)
    local[std::size_t(system.K.nodes.global(i))] = i;
  withDimAndOrder(body.mesh.dim, body.nodes.order,
                  [&](auto d, auto p) { addCells<d(), p()>(system.K, body, system.dofs.frames, local); });
  system.load = inOwnAxes(load, system.dofs.frames);
  return system;
}

double BodyModel::poissonRatio() const
{
  double largest = 0.0;
  for (const Elasticity& law : laws.all())
    largest = std::max(largest, effectivePoisson(law));
  return largest;
}

SparseField BodySystem::effectiveLoad(const Comm& comm) const
{
  if (dofs.prescribed.empty())
    return load;
  Vector held(load.size(), 0.0);
  dofs.addPrescribed(held);
  const Vector moved = multiply(K, held, comm);
  NodalField effective = load.all();
  for (std::size_t i = 0; i < effective.size(); ++i)
    effective[i] -= moved[i];
  return SparseField(effective);
}

} // namespace ndframe
