#include "solid_edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ndframe/mesh/tetrahedron_bisection.hpp"

namespace ndframe::test
{

Mesh cubes(int n)
{
  Mesh mesh;
  mesh.dim = 3;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        mesh.points.insert(mesh.points.end(), {double(i) / n, double(j) / n, double(k) / n});
  const int steps[3] = {1, n + 1, (n + 1) * (n + 1)};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<int, 3> order{0, 1, 2};
        do {
          int vertex = i * steps[0] + j * steps[1] + k * steps[2];
          std::array<int, 4> cell{vertex};
          for (std::size_t s = 0; s < 3; ++s)
            cell[s + 1] = vertex += steps[order[s]];
          mesh.cells.insert(mesh.cells.end(), cell.begin(), cell.end());
          if (cellMeasure(mesh, mesh.numCells() - 1) < 0.0)
            std::swap(*(mesh.cells.end() - 1), *(mesh.cells.end() - 2));
        } while (std::next_permutation(order.begin(), order.end()));
      }
  return mesh;
}

Mesh halvedEverywhere(const Mesh& mesh, int halvings)
{
  TetrahedronBisection bisection({mesh}, {});
  bisection.refine({std::vector<int>(std::size_t(mesh.numCells()), halvings)});
  return bisection.meshes()[0];
}

Vector edgeContributions(const Mesh& mesh, double lambda)
{
  Vector eta;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const auto centre = cellCentre(mesh, c);
    const double squared = centre[0] * centre[0] + centre[1] * centre[1];
    eta.push_back(std::sqrt(std::pow(cellMeasure(mesh, c), (2.0 * solidDegree + 3.0) / 3.0) *
                            std::pow(squared, lambda - 1.0 - solidDegree)));
  }
  return eta;
}

} // namespace ndframe::test
