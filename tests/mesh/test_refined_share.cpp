#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/drawn_parts.hpp"
#include "ndframe/mesh/refine.hpp"
#include "ndframe/mesh/refined_share.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

using Place = std::vector<double>;
using Number = RefinedNumbers::Number;

Mesh box(const char* corner, const char* cells, const char* pattern)
{
  const std::string origin = std::string(corner).size() > 4 ? "0, 0, 0" : "0, 0";
  return readMesh(text("Type", "Box") + doubles("Lower", origin) + doubles("Upper", corner) + ints("Cells", cells) +
                  text("Pattern", pattern));
}

std::vector<Mesh> samples()
{
  return {box("3, 1", "3, 2", "Crossed"), box("2, 1", "2, 3", "Alternating"), box("2, 1, 1", "2, 2, 1", "Right"),
          box("1, 1, 1", "1, 2, 2", "Alternating")};
}

Mesh refinedWhole(Mesh mesh, int halvings)
{
  for (int k = 0; k < halvings; ++k)
    mesh = refineUniformly(mesh);
  return mesh;
}

/// Vertices go to the ranks in turn, in an order that has nothing to do with their numbers.
DrawnOwners ownersOf(const Mesh& drawn, int ranks)
{
  DrawnOwners owners;
  for (int v = 0; v < drawn.numPoints(); ++v) {
    owners.order.push_back((7 * v + 3) % 101);
    owners.ranks.push_back(owners.order.back() % ranks);
  }
  return owners;
}

Place placeOf(const Mesh& mesh, int point)
{
  return {mesh.point(point), mesh.point(point) + mesh.dim};
}

/// The places of a cell's, or facet's, vertices: whatever they are called.
std::set<Place> corners(const Mesh& mesh, const int* vertices, int count)
{
  std::set<Place> places;
  for (int v = 0; v < count; ++v)
    places.insert(placeOf(mesh, vertices[v]));
  return places;
}

std::multiset<std::set<Place>> cellsOf(const Mesh& mesh, int count)
{
  std::multiset<std::set<Place>> cells;
  for (int c = 0; c < count; ++c)
    cells.insert(corners(mesh, mesh.cell(c), mesh.dim + 1));
  return cells;
}

/// The edges of a mesh by the places of their ends, with what DrawnPlace says of the middles.
std::map<std::set<Place>, DrawnPlace> edgesOf(const RefinedShare& share)
{
  std::map<std::set<Place>, DrawnPlace> edges;
  const Mesh& mesh = share.mesh;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int b = 1; b <= mesh.dim; ++b)
      for (int a = 0; a < b; ++a) {
        const int ends[2] = {mesh.cell(c)[a], mesh.cell(c)[b]};
        edges[corners(mesh, ends, 2)] =
            DrawnPlace::middle(share.points[std::size_t(ends[0])], share.points[std::size_t(ends[1])]);
      }
  return edges;
}

TEST(RefinedShare, NumbersAreThoseOfOneMesh)
{
  for (const Mesh& drawn : samples())
    for (int halvings = 0; halvings <= 3; ++halvings) {
      const RefinedNumbers numbers(drawn, halvings);
      const Mesh whole = refinedWhole(drawn, halvings);
      EXPECT_EQ(numbers.numPoints(), whole.numPoints());
      EXPECT_EQ(numbers.numCells(), whole.numCells());
      std::map<Number, Place> points;
      std::map<Number, std::set<Place>> middles;
      for (int rank = 0; rank < 3; ++rank) {
        const RefinedShare share = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 3), rank, {});
        EXPECT_TRUE(std::is_sorted(share.numbers.begin(), share.numbers.end()));
        for (int p = 0; p < share.mesh.numPoints(); ++p) {
          EXPECT_EQ(numbers.point(share.points[std::size_t(p)]), share.numbers[std::size_t(p)]);
          const auto [known, isNew] = points.insert({share.numbers[std::size_t(p)], placeOf(share.mesh, p)});
          EXPECT_EQ(known->second, placeOf(share.mesh, p)); // the same bits on all ranks
        }
        for (const auto& [ends, middle] : edgesOf(share))
          EXPECT_EQ(middles.insert({numbers.middle(middle), ends}).first->second, ends);
      }
      EXPECT_EQ(Number(points.size()), numbers.numPoints()); // none is missing, and none twice
      EXPECT_EQ(points.rbegin()->first + 1, numbers.numPoints());
      std::set<Place> places;
      for (int p = 0; p < whole.numPoints(); ++p)
        places.insert(placeOf(whole, p));
      for (const auto& [number, place] : points)
        EXPECT_EQ(places.erase(place), 1U);
      EXPECT_EQ(Number(middles.size()), numbers.numMiddles());
      EXPECT_EQ(middles.begin()->first, numbers.numPoints());
      EXPECT_EQ(middles.rbegin()->first + 1, numbers.numPoints() + numbers.numMiddles());
    }
}

TEST(RefinedShare, EachCellIsOneRanks)
{
  for (const Mesh& drawn : samples()) {
    const int halvings = 2;
    const RefinedNumbers numbers(drawn, halvings);
    const Mesh whole = refinedWhole(drawn, halvings);
    std::multiset<std::set<Place>> cells;
    for (int rank = 0; rank < 4; ++rank) {
      const RefinedShare share = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 4), rank, {"left"});
      for (const auto& cell : cellsOf(share.mesh, share.numOwnCells))
        cells.insert(cell);
    }
    EXPECT_EQ(cells, cellsOf(whole, whole.numCells()));
  }
}

TEST(RefinedShare, HasAllCellsAroundOwnNodesAndCommonSides)
{
  for (const Mesh& drawn : samples()) {
    const int halvings = 2;
    const RefinedNumbers numbers(drawn, halvings);
    const DrawnOwners owners = ownersOf(drawn, 3);
    const RefinedShare whole = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 1), 0, {});
    for (int rank = 0; rank < 3; ++rank) {
      const RefinedShare share = refinedShare(drawn, halvings, numbers, owners, rank, {"left"});
      const auto has = cellsOf(share.mesh, share.mesh.numCells());
      const Side* left = whole.mesh.findSide("left");
      std::set<int> touched;
      int vertices[3];
      for (const Facet facet : left->facets) {
        facetVertices(whole.mesh, facet, vertices);
        touched.insert(vertices, vertices + whole.mesh.dim);
      }
      std::size_t needed = 0;
      for (int c = 0; c < whole.mesh.numCells(); ++c) {
        bool isNeeded = false;
        for (int b = 0; b <= whole.mesh.dim; ++b) {
          const int v = whole.mesh.cell(c)[b];
          isNeeded = isNeeded || touched.count(v) > 0;
          for (int a = 0; a <= b; ++a)
            isNeeded =
                isNeeded || owners.rankOf(DrawnPlace::middle(whole.points[std::size_t(v)],
                                                             whole.points[std::size_t(whole.mesh.cell(c)[a])])) == rank;
        }
        needed += isNeeded ? 1 : 0;
        EXPECT_EQ(has.count(corners(whole.mesh, whole.mesh.cell(c), whole.mesh.dim + 1)), isNeeded ? 1U : 0U);
      }
      EXPECT_EQ(needed, has.size());
      EXPECT_EQ(share.mesh.findSide("left")->facets.size(), left->facets.size());
      EXPECT_EQ(share.mesh.sides.size(), drawn.sides.size());
    }
  }
}

TEST(RefinedShare, CommonSidesAreInOneOrder)
{
  const Mesh drawn = box("2, 1, 1", "2, 2, 2", "Alternating");
  const RefinedNumbers numbers(drawn, 2);
  std::vector<std::vector<Place>> orders;
  for (int rank = 0; rank < 3; ++rank) {
    const RefinedShare share = refinedShare(drawn, 2, numbers, ownersOf(drawn, 3), rank, {"top"});
    orders.emplace_back();
    int vertices[3];
    for (const Facet facet : share.mesh.findSide("top")->facets) {
      facetVertices(share.mesh, facet, vertices);
      for (const int vertex : vertices)
        orders.back().push_back(placeOf(share.mesh, vertex));
    }
  }
  EXPECT_FALSE(orders[0].empty());
  EXPECT_EQ(orders[0], orders[1]);
  EXPECT_EQ(orders[0], orders[2]);
}

void expectSame(const Mesh& one, const Mesh& other)
{
  EXPECT_EQ(one.points, other.points);
  EXPECT_EQ(one.cells, other.cells);
  EXPECT_EQ(one.notes, other.notes);
  EXPECT_EQ(one.groups.kind, other.groups.kind);
  EXPECT_EQ(one.groups.names, other.groups.names);
  ASSERT_EQ(one.sides.size(), other.sides.size());
  for (std::size_t s = 0; s < one.sides.size(); ++s) {
    EXPECT_EQ(one.sides[s].name, other.sides[s].name);
    ASSERT_EQ(one.sides[s].facets.size(), other.sides[s].facets.size());
    for (std::size_t f = 0; f < one.sides[s].facets.size(); ++f) {
      EXPECT_EQ(one.sides[s].facets[f].cell, other.sides[s].facets[f].cell);
      EXPECT_EQ(one.sides[s].facets[f].local, other.sides[s].facets[f].local);
    }
  }
}

/// A mesh with two groups of cells and a note.
Mesh withGroups(Mesh mesh)
{
  mesh.notes = {"drawn by hand"};
  mesh.groups.names = {{}, {"core", "hard"}};
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    mesh.groups.kind.push_back(cell % 3 == 0 ? 1 : 0);
  return mesh;
}

TEST(RefinedShare, OfAPartIsThatOfTheWhole)
{
  constexpr int ranks = 4;
  for (const Mesh& sample : samples())
    for (int halvings = 0; halvings <= 2; ++halvings) {
      const Mesh drawn = withGroups(sample);
      const RefinedNumbers numbers(drawn, halvings);
      const DrawnOwners owners = ownersOf(drawn, ranks);
      for (const std::vector<std::string>& sides : {std::vector<std::string>(), {"left"}, {"left", "top"}}) {
        DrawnParts parts(drawn, halvings, numbers, owners, sides, ranks);
        for (const int rank : {2, 0, 3, 1, 2}) { // in any order, and again
          const DrawnPart part = drawnPartFromBytes(parts.bytesOf(rank));
          EXPECT_EQ(part.halvings, halvings);
          EXPECT_EQ(part.numbers.numPoints(), numbers.numPoints());
          EXPECT_EQ(part.numbers.numMiddles(), numbers.numMiddles());
          EXPECT_EQ(part.numbers.numCells(), numbers.numCells());
          const RefinedShare whole = refinedShare(drawn, halvings, numbers, owners, rank, sides);
          const RefinedShare share = refinedShare(part.mesh, halvings, part.numbers, part.owners, rank, sides);
          expectSame(share.mesh, whole.mesh);
          EXPECT_EQ(share.numbers, whole.numbers);
          EXPECT_EQ(share.numOwnCells, whole.numOwnCells);
          const auto edges = edgesOf(share), edgesOfWhole = edgesOf(whole);
          ASSERT_EQ(edges.size(), edgesOfWhole.size());
          for (const auto& [ends, middle] : edges) {
            EXPECT_EQ(part.numbers.middle(middle), numbers.middle(edgesOfWhole.at(ends)));
            EXPECT_EQ(part.owners.rankOf(middle), owners.rankOf(edgesOfWhole.at(ends)));
          }
        }
      }
    }
}

TEST(RefinedShare, PartsAreSmall)
{
  const Mesh drawn = box("4, 1, 1", "16, 2, 2", "Right");
  const RefinedNumbers numbers(drawn, 0);
  DrawnOwners owners;
  for (int v = 0; v < drawn.numPoints(); ++v) { // a slab each
    owners.order.push_back(v);
    owners.ranks.push_back(std::min(3, int(drawn.point(v)[0])));
  }
  DrawnParts parts(drawn, 0, numbers, owners, {}, 4);
  for (int rank = 0; rank < 4; ++rank) {
    const DrawnPart part = drawnPartFromBytes(parts.bytesOf(rank));
    for (int cell = 0; cell < part.mesh.numCells(); ++cell) // one layer of cells beyond its own
      for (int v = 0; v < 4; ++v)
        EXPECT_LE(std::abs(part.mesh.point(part.mesh.cell(cell)[v])[0] - (rank + 0.5)), 0.75 + 1e-12);
    EXPECT_LE(part.mesh.numCells(), drawn.numCells() * 6 / 16);
  }
}

TEST(RefinedShare, NumbersGoBeyondThoseOfARank)
{
  const Mesh drawn = box("1, 1, 1", "4, 4, 4", "Right");
  const RefinedNumbers numbers(drawn, 8); // 384 cells become 6.4e9
  EXPECT_EQ(numbers.numCells(), Number(384) << 24U);
  EXPECT_EQ(numbers.numPoints(), Number(1025) * 1025 * 1025);
  EXPECT_EQ(numbers.numPoints() + numbers.numMiddles(), Number(2049) * 2049 * 2049);
  DrawnPlace inside{{}, {1, 1, 253, 257}, 4};
  std::copy_n(drawn.cell(383), 4, inside.vertices.begin());
  std::sort(inside.vertices.begin(), inside.vertices.end());
  EXPECT_GT(numbers.middle(inside), numbers.numPoints());
  EXPECT_LT(numbers.middle(inside), numbers.numPoints() + numbers.numMiddles());
}

/// A cell's number is its place in the mesh that is refined as a whole; ranks agree on its owner.
TEST(RefinedShare, CellsAreNumberedLikeThoseOfOneMesh)
{
  for (const Mesh& drawn : samples()) {
    const int halvings = 2;
    const RefinedNumbers numbers(drawn, halvings);
    const Mesh whole = refinedWhole(drawn, halvings);
    std::map<Number, int> owners;
    for (int rank = 0; rank < 3; ++rank) {
      const RefinedShare share = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 3), rank, {"left"}, true);
      for (int c = 0; c < share.mesh.numCells(); ++c) {
        const Number number = share.cellNumbers[std::size_t(c)];
        EXPECT_EQ(corners(share.mesh, share.mesh.cell(c), drawn.dim + 1),
                  corners(whole, whole.cell(int(number)), drawn.dim + 1));
        EXPECT_EQ(share.cellOwners[std::size_t(c)] == rank, c < share.numOwnCells);
        EXPECT_EQ(owners.emplace(number, share.cellOwners[std::size_t(c)]).first->second,
                  share.cellOwners[std::size_t(c)]);
      }
    }
    EXPECT_EQ(Number(owners.size()), numbers.numCells());
  }
}

TEST(RefinedShare, HaloIsAllCellsAtVerticesOfOwnCells)
{
  for (const Mesh& drawn : samples())
    for (int halvings = 0; halvings <= 2; ++halvings) {
      const RefinedNumbers numbers(drawn, halvings);
      const RefinedShare whole = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 1), 0, {});
      for (int rank = 0; rank < 3; ++rank) {
        const RefinedShare share = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 3), rank, {}, true);
        std::set<Number> own, held(share.cellNumbers.begin(), share.cellNumbers.end());
        for (int c = 0; c < share.numOwnCells; ++c)
          for (int v = 0; v <= drawn.dim; ++v)
            own.insert(share.numbers[std::size_t(share.mesh.cell(c)[v])]);
        for (int c = 0; c < whole.mesh.numCells(); ++c) {
          const int* v = whole.mesh.cell(c);
          if (std::any_of(v, v + drawn.dim + 1,
                          [&](int point) { return own.count(whole.numbers[std::size_t(point)]) > 0; }))
            EXPECT_EQ(held.count(whole.cellNumbers[std::size_t(c)]), 1U);
        }
      }
    }
}

/// Facets of a side come in the order of the whole mesh's, so that interfaces are numbered alike.
TEST(RefinedShare, FacetsComeInTheOrderOfTheWholeMesh)
{
  for (const Mesh& drawn : samples()) {
    const int halvings = 2;
    const RefinedNumbers numbers(drawn, halvings);
    const Mesh whole = refinedWhole(drawn, halvings);
    const RefinedShare share = refinedShare(drawn, halvings, numbers, ownersOf(drawn, 3), 1, {"left"});
    const std::vector<Facet>&there = whole.findSide("left")->facets, &here = share.mesh.findSide("left")->facets;
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t f = 0; f < here.size(); ++f) {
      EXPECT_EQ(share.cellNumbers[std::size_t(here[f].cell)], there[f].cell);
      EXPECT_EQ(here[f].local, there[f].local);
    }
  }
}

} // namespace
