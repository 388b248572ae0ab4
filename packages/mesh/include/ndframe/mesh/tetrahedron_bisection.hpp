#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ndframe/mesh/facet_twin.hpp"

namespace ndframe
{

/// Bisection of tetrahedron meshes that match along interfaces, and go on matching.
///
/// A tetrahedron is halved only by the plane through the middle of its longest edge and the two vertices that are not
/// on it (longest-edge bisection, Rivara 1984). "Longest" is a strict order of all edges: by length, where lengths
/// within 1e-6 of each other are equal but for what rounding puts apart, then by the position of the middle, never by
/// number. So the triangles of a facet are the same seen from both its cells, and the forest of all descendants is
/// fixed by the first meshes: what refine() makes is the smallest conforming part of it that has what was asked for.
///
/// The closure halves every cell that has a halved edge. It ends: the edges that are halved for an edge's sake are none
/// shorter than it, every new edge is at most 0.87 times (a median of triangles) the one whose halving made it, and a
/// mesh has finitely many edges above a length. The meshes are bisected as one mesh in which the vertices of twins are
/// the same; each keeps its own coordinates, a new point being the middle of its two parents.
///
/// Shapes: stretched cells become rounder on average, for their long edges go first. The descendants of Kuhn's
/// tetrahedra in a cube have three shapes, the worst as good as the first (0.756, tetrahedronShape). That the shapes of
/// any tetrahedron's descendants are bounded has been seen in experiments (Hannukainen, Korotov and Krizek 2014) and is
/// not proved: of 300 random tetrahedra the worst descendant within 12 halvings had 0.46 to 1 times the first shape, a
/// sixth of a brick of 2 : 1 : 1 goes from 0.55 to 0.37.
///
/// Limits: straight edges. Nothing is coarsened. A body's mesh does not depend on the order of the bodies.
class TetrahedronBisection
{
public:
  /// Sound tetrahedron meshes (checkMesh). A facet has at most one twin.
  TetrahedronBisection(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins);

  /// Halves every cell at least so often (all its descendants), and others as conformity needs.
  ///
  /// halvings: per mesh and cell of meshes(); not negative. Points keep their numbers and coordinates, new ones follow.
  /// Descendants stand where the cell stood, the parts of a side's facet where it stood.
  void refine(const std::vector<std::vector<int>>& halvings);

  const std::vector<Mesh>& meshes() const { return meshes_; } ///< refined so far, in the order given
  /// Per mesh and cell of meshes(): the cell before the last refine() of which it is a part. Ascending.
  const std::vector<std::vector<int>>& parents() const { return parents_; }

private:
  struct Tetrahedron
  {
    std::array<int, 4> vertices; ///< points of its mesh
    std::array<int, 4> facets;   ///< number of the first facet of a side in which each of its own lies; -1: none
    int parent;                  ///< cell of its mesh before refine()
    int halvings;                ///< still wanted
  };

  /// By two vertices, in any order.
  using Middles = std::unordered_map<std::uint64_t, int>;

  void addCells(const Mesh& mesh);
  void numberFacets(const Mesh& mesh);
  void identify(const std::vector<FacetTwin>& twins);

  bool halveOnce();
  void addDescendants(const Tetrahedron& cell, std::size_t mesh);
  bool hasHalvedEdge(const Tetrahedron& cell, std::size_t mesh) const;
  std::array<std::size_t, 2> longestEdge(const Tetrahedron& cell, std::size_t mesh) const;
  int middleOf(int a, int b, std::size_t mesh);
  int sharedMiddle(int a, int b);

  void numberNewPoints(std::size_t mesh, int numOld);
  void writeMesh(std::size_t mesh);

  std::vector<Mesh> meshes_;
  std::vector<std::vector<int>> parents_;
  std::vector<std::vector<Tetrahedron>> cells_;      ///< per mesh
  std::vector<std::vector<int>> shared_;             ///< per mesh and point: the vertex of the one mesh
  std::vector<std::array<double, 3>> places_;        ///< of those vertices; of twins the smallest
  std::vector<std::vector<std::vector<int>>> sides_; ///< per mesh and side: the numbers of its first facets
  std::vector<int> numFacets_;                       ///< per mesh: that have numbers

  // While refining.
  Middles halved_;              ///< edges of the one mesh
  std::vector<char> isEnd_;     ///< per vertex of the one mesh: whether any of its edges is halved
  std::vector<Middles> points_; ///< per mesh
};

} // namespace ndframe
