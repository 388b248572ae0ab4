#pragma once

#include <array>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe::test
{

/// Reproducible numbers.
class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  /// In (low, high).
  double operator()(double low = -1.0, double high = 1.0)
  {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  std::vector<double> vector(std::size_t size);
  std::vector<int> permutation(int size);

private:
  std::mt19937 engine_;
};

/// The box from the origin to `upper` (default: one in every direction), read through the registry of mesh sources.
/// `rotation`: degrees about the z axis.
Mesh box(const std::vector<int>& cells, const std::string& pattern = "Right", double rotation = 0.0,
         std::vector<double> upper = {});

/// The mesh with its points moved by `map` (in place, dim components).
Mesh moved(Mesh mesh, const std::function<void(double* point)>& map);

/// The mesh with the points that lie on no side moved by up to `amount`.
Mesh shaken(const Mesh& mesh, double amount, unsigned seed);

/// The same mesh with points and cells in another order and the cells' vertices permuted evenly.
Mesh renumbered(const Mesh& mesh, unsigned seed);

/// Facets of all sides.
int numBoundaryFacets(const Mesh& mesh);

/// One cell with random vertices, neither flat nor inverted.
Mesh randomCell(int dim, unsigned seed);

} // namespace ndframe::test
