#include "ndframe/fem/prolongation.hpp"

#include <array>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/mesh/refine.hpp"

namespace ndframe
{
namespace
{

/// The parent's basis functions at the nodes of a child, nodes x nodes: the same for every cell of a mesh.
template <int dim, int order>
struct ChildValues
{
  static constexpr int nodes = Lagrange<dim, order>::nodes;
  double N[nodes][nodes];

  explicit ChildValues(int child)
  {
    double vertices[dim + 1][dim + 1] = {};
    for (int v = 0; v <= dim; ++v)
      for (const int parent : childVertices(dim, child)[v])
        vertices[v][parent] += 0.5;
    for (int v = 0; v <= dim; ++v)
      Lagrange<dim, order>::values(vertices[v], N[v]);
    for (int e = 0; e < nodes - dim - 1; ++e) {
      const auto [a, b] = SimplexEdges<dim>::vertices[std::size_t(e)];
      double middle[dim + 1];
      for (int k = 0; k <= dim; ++k)
        middle[k] = 0.5 * (vertices[a][k] + vertices[b][k]);
      Lagrange<dim, order>::values(middle, N[dim + 1 + e]);
    }
  }
};

template <int dim, int order>
void prolongateCells(const NodeMap& coarse, const NodeMap& fine, const std::vector<double>& values,
                     std::vector<double>& result)
{
  constexpr int nodes = Lagrange<dim, order>::nodes;
  const int children = numChildren(dim);
  for (int child = 0; child < children; ++child) {
    const ChildValues<dim, order> table(child);
    for (int c = 0; c < coarse.numCells(); ++c)
      for (int a = 0; a < nodes; ++a) {
        std::array<double, dim> value{};
        for (int b = 0; b < nodes; ++b)
          for (int k = 0; k < dim; ++k)
            value[std::size_t(k)] +=
                table.N[a][b] * values[std::size_t(coarse.cell(c)[b]) * std::size_t(dim) + std::size_t(k)];
        for (int k = 0; k < dim; ++k)
          result[std::size_t(fine.cell(c * children + child)[a]) * std::size_t(dim) + std::size_t(k)] =
              value[std::size_t(k)];
      }
  }
}

} // namespace

std::vector<double> prolongate(const NodeMap& coarse, const NodeMap& fine, const std::vector<double>& values)
{
  NDFRAME_ASSERT(fine.order == coarse.order && fine.numCells() == coarse.numCells() * numChildren(coarse.dim),
                 "the fine nodes are those of the refined mesh");
  std::vector<double> result(std::size_t(fine.numNodes()) * std::size_t(fine.dim));
  withDimAndOrder(coarse.dim, coarse.order,
                  [&](auto d, auto p) { prolongateCells<d(), p()>(coarse, fine, values, result); });
  return result;
}

} // namespace ndframe
