// What cells lack of balance, handed on in two steps: every cell gets it, whatever ranks have the cells.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "assembly/sample_body.hpp"
#include "common/test_main.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/equilibrium/facet_twins.hpp"
#include "ndframe/flow/block_flow.hpp"
#include "ndframe/mesh/partition.hpp"

namespace ndframe
{
namespace
{

std::vector<ForceMoment> noise(const BlockFlow& flow, int cells)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<ForceMoment> lacks(std::size_t(cells), ForceMoment{});
  ForceMoment total{};
  for (int cell = 1; cell < cells; ++cell) {
    for (double& value : lacks[std::size_t(cell)])
      value = number(random);
    addMoved(lacks[std::size_t(cell)], flow.centre(cell), flow.centre(0), total);
  }
  for (std::size_t i = 0; i < total.size(); ++i)
    lacks[0][i] = -total[i];
  return lacks;
}

/// What cells lack when they have been given what passes through their half facets.
std::vector<ForceMoment> left(const Mesh& mesh, const BlockFlow& flow, std::vector<ForceMoment> lacks,
                              const std::vector<ForceMoment>& through)
{
  for (std::size_t half = 0; half < through.size(); ++half) {
    const std::size_t cell = half / 4;
    const Facet facet{int(cell), sortedCell(mesh, int(cell)).local[half % 4]};
    ForceMoment given = through[half];
    for (double& value : given)
      value = -value;
    addMoved(given, facetCentre(mesh, facet), flow.centre(int(cell)), lacks[cell]);
  }
  return lacks;
}

double largest(const std::vector<ForceMoment>& wrenches)
{
  double value = 0.0;
  for (const ForceMoment& wrench : wrenches)
    for (const double entry : wrench)
      value = std::max(value, std::abs(entry));
  return value;
}

/// Two boxes that do not touch each other.
Mesh twoBoxes()
{
  Mesh both = test::box({6, 6, 6}, "Right", 35.0);
  const Mesh second = test::moved(test::box({9, 5, 4}), [](double* x) { x[0] += 7.0; });
  for (const int vertex : second.cells)
    both.cells.push_back(vertex + both.numPoints());
  both.points.insert(both.points.end(), second.points.begin(), second.points.end());
  both.sides.clear();
  return both;
}

BodyPiece pieceOf(const BodyModel& body, const std::vector<int>& owner)
{
  StaticData data;
  data.dim = 3;
  data.order = body.nodes.order;
  data.degree = 2;
  std::vector<char> isTouched(std::size_t(body.mesh.numPoints()), 0);
  for (int cell = 0; cell < body.mesh.numCells(); ++cell)
    for (int v = 0; v < 4 && owner[std::size_t(cell)] == test::comm().rank(); ++v)
      isTouched[std::size_t(body.mesh.cell(cell)[v])] = 1;
  return cutPiece(body, data, owner, isTouched, test::comm());
}

std::vector<int> byPlace(const Mesh& mesh, int ranks)
{
  std::vector<std::array<double, 3>> centres;
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    centres.push_back(cellCentre(mesh, cell));
  return partitionByPlace(centres, ranks);
}

std::vector<int> anyhow(const Mesh& mesh, int ranks)
{
  std::mt19937 random(8);
  std::vector<int> owner;
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    owner.push_back(int(random() % unsigned(ranks)));
  return owner;
}

} // namespace

TEST(BlockFlow, GivesEveryCellWhatItLacks)
{
  const Mesh flat = test::box({30, 30, 1}, "Right", 35.0, {1.0, 1.0, 0.01});
  for (const Mesh& mesh : {test::box({3, 2, 2}, "Right", 35.0), test::box({9, 8, 7}, "Right", 35.0), flat})
  { // one box, several
    const BlockFlow flow(mesh, nullptr, Comm::single());
    ASSERT_EQ(flow.numParts(), 1);
    const std::vector<ForceMoment> lacks = noise(flow, mesh.numCells());
    EXPECT_LT(largest(left(mesh, flow, lacks, flow.through(lacks))), 1e-10);
  }
}

/// Cells of both sides of a face get opposite wrenches, and facets of the boundary nothing.
TEST(BlockFlow, PassesFromCellToCell)
{
  const Mesh mesh = test::box({9, 8, 7}, "Right", 35.0);
  const BlockFlow flow(mesh, nullptr, Comm::single());
  const std::vector<ForceMoment> through = flow.through(noise(flow, mesh.numCells()));
  const std::vector<int> twins = facetTwins(sortedCells(mesh), 3);
  for (std::size_t half = 0; half < through.size(); ++half)
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(through[half][i], twins[half] < 0 ? 0.0 : -through[std::size_t(twins[half])][i]);
}

/// However the ranks share the cells, what passes through faces is the same but for round-off.
TEST(BlockFlow, IsThatOfOneProcess)
{
  for (const Mesh& given : {test::box({9, 8, 7}, "Right", 35.0), twoBoxes()}) {
    const Mesh mesh = test::renumbered(given, 4);
    BodyModel body;
    body.name = "body";
    body.mesh = mesh;
    body.nodes = makeNodeMap(mesh, 1);
    body.laws = test::makeBody(test::box({1, 1, 1}), 1, {}).laws;
    for (const auto& owner : {byPlace(mesh, test::comm().size()), anyhow(mesh, test::comm().size())}) {
      const BodyPiece piece = pieceOf(body, owner);
      const BlockFlow alone(mesh, nullptr, Comm::single()), together(piece.model.mesh, &piece, test::comm());
      const std::vector<ForceMoment> lacks = noise(alone, mesh.numCells()), expected = alone.through(lacks);
      std::vector<ForceMoment> own, difference;
      for (std::size_t cell = 0; cell < piece.cells.size(); ++cell)
        own.push_back(piece.owns(int(cell)) ? lacks[std::size_t(piece.cells[cell])] : ForceMoment{});
      const std::vector<ForceMoment> found = together.through(own);
      for (std::size_t cell = 0; cell < piece.cells.size(); ++cell)
        for (std::size_t facet = 0; facet < 4; ++facet) {
          difference.push_back(found[4 * cell + facet]);
          for (std::size_t i = 0; i < 6 && piece.owns(int(cell)); ++i)
            difference.back()[i] -= expected[4 * std::size_t(piece.cells[cell]) + facet][i];
        }
      EXPECT_LT(largest(difference), 1e-10 * largest(expected));
      EXPECT_EQ(together.numParts(), alone.numParts());
    }
  }
}

} // namespace ndframe
