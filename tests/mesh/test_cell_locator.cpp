#include "ndframe/mesh/cell_locator.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/tetrahedron_bisection.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using Point = std::array<double, 3>;

/// The cube [0, 1]^3, with cells that become smaller towards a corner.
Mesh gradedCube()
{
  const std::string cube = doubles("Lower", "0, 0, 0") + doubles("Upper", "1, 1, 1") + ints("Cells", "3, 2, 4");
  TetrahedronBisection bisection({readMesh(text("Type", "Box") + cube)}, {});
  for (int i = 0; i < 12; ++i) {
    const Mesh& mesh = bisection.meshes()[0];
    std::vector<int> halvings;
    for (int c = 0; c < mesh.numCells(); ++c) {
      const Point centre = cellCentre(mesh, c);
      halvings.push_back(std::hypot(centre[0], centre[1], centre[2]) < std::pow(0.7, i) ? 1 : 0);
    }
    bisection.refine({halvings});
  }
  return bisection.meshes()[0];
}

Point pointOf(const Mesh& mesh, const CellLocator::Place& place)
{
  Point point{};
  for (std::size_t v = 0; v < 4; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      point[k] += place.weights[v] * mesh.point(mesh.cell(place.cell)[v])[k];
  return point;
}

void expectWeights(const CellLocator::Place& place)
{
  double sum = 0.0;
  for (const double weight : place.weights) {
    EXPECT_GE(weight, 0.0);
    sum += weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

} // namespace

TEST(CellLocator, FindsTheTetrahedronThatHoldsAPoint)
{
  const Mesh mesh = gradedCube();
  const CellLocator locator(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(any(random), i % 8);
    const Point point{scale * any(random), scale * any(random), any(random)};
    const CellLocator::Place place = locator.find(point);
    EXPECT_EQ(place.squaredDistance, 0.0);
    expectWeights(place);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(pointOf(mesh, place)[k], point[k], 1e-13);
  }
}

TEST(CellLocator, FindsWhatIsNearestToAPointOutside)
{
  const Mesh mesh = gradedCube();
  const CellLocator locator(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 2.0);
  for (int i = 0; i < 2000; ++i) {
    const Point point{any(random), any(random), any(random)};
    const CellLocator::Place place = locator.find(point);
    expectWeights(place);
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double nearest = std::clamp(point[k], 0.0, 1.0); // of the cube
      squared += (point[k] - nearest) * (point[k] - nearest);
      EXPECT_NEAR(pointOf(mesh, place)[k], nearest, 1e-12);
    }
    EXPECT_NEAR(place.squaredDistance, squared, 1e-12);
  }
}

TEST(CellLocator, FindsNothingForWhatIsNoPoint)
{
  const Mesh mesh = gradedCube();
  EXPECT_EQ(CellLocator(mesh).find({0.5, std::nan(""), 0.5}).cell, -1);
}
