#include "ndframe/interface/traction_transfer.hpp"

#include <algorithm>
#include <limits>

#include "facet_tree.hpp"
#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{
namespace
{

/// Distances that differ by less, relatively, are equal: a new node halfway between two old ones.
constexpr double equallyNear = 1e-6;

/// The value of a polynomial with these nodal values at a place on the mesh.
double valueAt(const InterfaceMesh& mesh, const double* values, const FacetTree::Place& place)
{
  return withDimAndOrder(mesh.dim, mesh.order, [&](auto d, auto p) {
    using Shape = Lagrange<d() - 1, p()>;
    double N[Shape::nodes], value = 0.0;
    Shape::values(place.lambda.data(), N);
    for (int a = 0; a < Shape::nodes; ++a)
      value += N[a] * values[mesh.nodesOf(place.facet)[a]];
    return value;
  });
}

double squaredDistance(const double* x, const double* y, int dim)
{
  double squared = 0.0;
  for (int k = 0; k < dim; ++k)
    squared += (x[k] - y[k]) * (x[k] - y[k]);
  return squared;
}

/// Whether a closed node of the facet is as near as the open ones.
char closedAt(const InterfaceMesh& mesh, const char* closed, const FacetTree::Place& place, const double* x)
{
  double nearest[] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}; // open, closed
  for (int a = 0; a < mesh.nodesPerFacet(); ++a) {
    const int node = mesh.nodesOf(place.facet)[a];
    double& best = nearest[closed[node] ? 1 : 0];
    best = std::min(best, squaredDistance(x, mesh.point(node), mesh.dim));
  }
  return nearest[1] <= (1.0 + equallyNear) * nearest[0];
}

/// What `at(mesh, values of its nodes, place, point)` says for all nodes of `to`.
template <class Value, class At>
std::vector<Value> transfer(const std::vector<InterfaceMesh>& from, const std::vector<Value>& values,
                            const std::vector<InterfaceMesh>& to, const At& at)
{
  NDFRAME_ASSERT(from.size() == to.size(), "a transfer needs the same interfaces on both sides");
  std::vector<Value> result;
  const Value* first = values.data();
  for (std::size_t k = 0; k < from.size(); ++k) {
    const FacetTree tree(from[k]);
    for (int i = 0; i < to[k].numNodes(); ++i)
      result.push_back(at(from[k], first, tree.nearest(to[k].point(i)), to[k].point(i)));
    first += from[k].numNodes();
  }
  NDFRAME_ASSERT(first == values.data() + values.size(), "a transfer needs one value per interface node");
  return result;
}

} // namespace

InterfaceValues transferTraction(const std::vector<InterfaceMesh>& from, const InterfaceValues& traction,
                                 const std::vector<InterfaceMesh>& to)
{
  return atInterface(transfer(from, traction.whole(), to,
                              [](const InterfaceMesh& mesh, const double* values, const FacetTree::Place& place,
                                 const double*) { return valueAt(mesh, values, place); }));
}

std::vector<char> transferClosed(const std::vector<InterfaceMesh>& from, const std::vector<char>& closed,
                                 const std::vector<InterfaceMesh>& to)
{
  return transfer(from, closed, to, closedAt);
}

std::vector<char> statusesOfNodes(const InterfaceSystem& system, const std::vector<char>& ofUnknowns)
{
  std::vector<char> ofNodes(std::size_t(system.C->size()), 1);
  for (std::size_t i = 0; i < ofUnknowns.size(); ++i)
    ofNodes[std::size_t(system.nodeOfUnknown[i])] = ofUnknowns[i];
  return ofNodes;
}

std::vector<char> statusesOfUnknowns(const InterfaceSystem& system, const std::vector<char>& ofNodes)
{
  std::vector<char> ofUnknowns;
  for (const int node : system.nodeOfUnknown)
    ofUnknowns.push_back(ofNodes[std::size_t(node)]);
  return ofUnknowns;
}

} // namespace ndframe
