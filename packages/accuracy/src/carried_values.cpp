#include <algorithm>
#include <numeric>

#include "carried_solution.hpp"
#include "ndframe/algebra/exchanged_values.hpp"

namespace ndframe
{
namespace
{

/// The places of the nodes of a whole body, of second order, in the order of the numbers that they have in shares
/// (RefinedNumbers): vertices, then middles of edges by their ends.
std::vector<int> inOrder(const NodeMap& nodes)
{
  std::vector<int> order(std::size_t(nodes.numNodes()));
  std::iota(order.begin(), order.end(), 0);
  const auto ends = [&](int node) {
    const auto [a, b] = nodes.ends(node);
    return std::minmax({a, b});
  };
  std::sort(order.begin() + nodes.numVertices(), order.end(), [&](int a, int b) { return ends(a) < ends(b); });
  return order;
}

template <class Number>
Vector taken(const Vector& values, const std::vector<Number>& nodes, int dim)
{
  Vector result;
  for (const Number node : nodes) {
    const auto first = values.begin() + std::ptrdiff_t(node) * dim;
    result.insert(result.end(), first, first + dim);
  }
  return result;
}

/// What `taken` took from.
Vector givenBack(const Vector& values, const std::vector<int>& nodes, int dim)
{
  Vector result(values.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    std::copy_n(values.begin() + std::ptrdiff_t(i) * dim, dim, result.begin() + std::ptrdiff_t(nodes[i]) * dim);
  return result;
}

/// On rank 0, from the parts of all ranks. Collective.
Vector gathered(const Vector& ofPart, int dim, const BodyShare& share, const Comm& comm)
{
  std::vector<Vector> sent(std::size_t(comm.size()));
  for (const int node : share.ownNodes()) {
    sent[0].push_back(double(share.numbers()[std::size_t(node)]));
    const auto first = ofPart.begin() + std::ptrdiff_t(node) * dim;
    sent[0].insert(sent[0].end(), first, first + dim);
  }
  const std::vector<Vector> received = exchangedValues(sent, comm);
  Vector all(comm.rank() == 0 ? std::size_t(share.numNodes()) * std::size_t(dim) : 0);
  for (const Vector& message : received)
    for (auto next = message.begin(); next != message.end(); next += dim + 1)
      std::copy_n(next + 1, dim, all.begin() + std::ptrdiff_t(*next) * dim);
  return all;
}

} // namespace

CarriedSolution::CarriedSolution(const Model& model, const std::vector<Vector>& values)
{
  auto next = values.begin();
  for (const int b : model.elasticBodies()) {
    const BodyModel& body = model.bodies[std::size_t(b)];
    if (next == values.end() || std::int64_t(next->size()) != body.totalDofs())
      throw InputError("The displacements to go on from are those of other meshes.");
    add(body, body.share ? taken(*next, body.share->numbers(), body.mesh.dim)
                         : givenBack(*next, inOrder(body.nodes), body.mesh.dim));
    ++next;
  }
}

std::vector<Vector> CarriedSolution::values(const Comm& comm) const
{
  std::vector<Vector> values;
  for (const Body& body : bodies_)
    values.push_back(body.share ? gathered(body.values, body.nodes.dim, *body.share, comm)
                                : taken(body.values, inOrder(body.nodes), body.nodes.dim));
  return values;
}

} // namespace ndframe
