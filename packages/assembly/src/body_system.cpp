#include "ndframe/assembly/body_system.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/body_loads.hpp"
#include "ndframe/base/diagnostics.hpp"
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

/// The entries of K, which are zero.
void fill(BodySystem& system, const BodyModel& body)
{
  BlockMatrix& K = system.K;
  std::vector<int> local(std::size_t(body.nodes.numNodes()), -1);
  for (int i = 0; i < K.nodes.size(); ++i)
    local[std::size_t(system.share ? system.partNodes[std::size_t(i)] : K.nodes.global(i))] = i;
  withDimAndOrder(body.mesh.dim, body.nodes.order,
                  [&](auto d, auto p) { addCells<d(), p()>(K, body, system.dofs.frames, local); });
  for (int r = 0; r < K.numRows(); ++r)
    if (const double* block = K.block(r, r))
      for (int i = 0; i < K.dim; ++i)
        system.largestOwn = std::max(system.largestOwn, std::abs(block[std::ptrdiff_t(i) * (K.dim + 1)]));
}

/// Numbers the nodes of K as the whole body does: both ascend.
void shareOut(BodySystem& system, const std::shared_ptr<const BodyShare>& share)
{
  IndexMap& nodes = system.K.nodes;
  std::vector<IndexMap::Global> owned, held;
  for (int i = 0; i < nodes.size(); ++i) {
    system.partNodes.push_back(int(nodes.global(i)));
    (nodes.owns(i) ? owned : held).push_back(share->numbers()[std::size_t(nodes.global(i))]);
  }
  nodes = IndexMap(share->numNodes(), std::move(owned), std::move(held));
  system.share = share;
}

double largestModulus(const Vector& values, const Comm& comm)
{
  Vector largest{0.0};
  for (const double value : values)
    largest[0] = std::max(largest[0], std::abs(value));
  takeLargest(largest, comm);
  return largest[0];
}

/// Values at own nodes as K numbers them.
SparseField ownOf(const BodySystem& system, const Vector& ofPart, const Comm& comm)
{
  std::vector<IndexMap::Global> owned;
  Vector own;
  for (int r = 0; r < system.K.numRows(); ++r) {
    const auto first = ofPart.begin() + std::ptrdiff_t(system.partNodes[std::size_t(r)]) * system.K.dim;
    if (std::all_of(first, first + system.K.dim, [](double value) { return value == 0.0; }))
      continue;
    owned.push_back(system.K.nodes.global(r));
    own.insert(own.end(), first, first + system.K.dim);
  }
  const double largest = largestModulus(own, comm);
  return SparseField::ofOwn({IndexMap(system.share->numNodes(), std::move(owned)), system.K.dim, std::move(own)},
                            largest);
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
  if (body.share)
    shareOut(system, body.share);
  fill(system, body);
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
  if (share) {
    Vector effective = load.all().whole();
    if (!dofs.prescribed.empty()) {
      Vector held(effective.size(), 0.0);
      dofs.addPrescribed(held);
      const Vector moved = productOfPart(held);
      for (std::size_t i = 0; i < effective.size(); ++i)
        effective[i] -= moved[i];
    }
    return ownOf(*this, effective, comm);
  }
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

Vector BodySystem::productOfPart(const Vector& u) const
{
  NDFRAME_ASSERT(share && u.size() == dofs.roles.size(), "values at all nodes of a part");
  Vector product(u.size(), 0.0);
  addProduct(K, u, product, [this](int node) { return partNodes[std::size_t(node)]; });
  return product;
}

Vector BodySystem::forcesOf(const Vector& u, const Comm& comm) const
{
  return share ? productOfPart(u) : multiply(K, u, comm);
}

double BodySystem::largestDiagonal(const Comm& comm) const
{
  return largestModulus({largestOwn}, comm);
}

void giveBackStiffness(BodySystem& system)
{
  Vector().swap(system.K.values);
}

void assembleAgain(BodySystem& system, const BodyModel& body)
{
  if (!system.K.values.empty())
    return;
  system.K.makeValues();
  fill(system, body);
}

} // namespace ndframe
