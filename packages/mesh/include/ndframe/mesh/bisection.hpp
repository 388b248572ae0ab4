#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/facet_twin.hpp"

namespace ndframe
{

/// Bisection of triangle meshes that match along interfaces, and go on matching; stretched cells become rounder.
///
/// Every triangle has a refinement edge and is halved only by joining its middle to the opposite vertex, the peak; the
/// middle is the peak of both halves (newest-vertex bisection). So the descendants of a triangle have at most four
/// shapes, however often they are halved. At the start the refinement edge is the longest edge; among equally long ones
/// it is chosen so that neighbours agree as far as possible, by position and not by number.
///
/// That keeps what is well shaped and does not mend what is not. So the cells that a call of refine() makes are looked
/// at again:
///   1. A half whose longest edge promises clearly better descendants takes that as its refinement edge (longest-edge
///      bisection, Rivara 1984).
///   2. At the end an edge inside a body goes to the other diagonal of its two triangles' quadrilateral where the worse
///      of their shapes becomes clearly better (as Lawson does for angles), and so on with its neighbours.
/// Both are done only if the worst of the four shapes to come of a triangle gets no worse by it; halving cannot worsen
/// it either. So no cell is ever worse shaped than the worst of the four of all first cells, that is, than 0.6 times
/// the worst first shape (worstShape). Half squares have the best four shapes of all and are never changed.
///
/// The closure marks edges: a cell that has a marked edge also marks its refinement edge, until nothing changes. It
/// ends for any choice of refinement edges; where nothing is mended, after any number of calls there are O(halvings
/// asked for) more triangles (Karkulik, Pavlicek and Praetorius 2013). The meshes are bisected as one mesh in which
/// twins are the same edge; each keeps its own coordinates, a new point being the middle of its two parents. Facets of
/// sides and interfaces, and edges between cells of different groups, are halved and never swapped.
///
/// Limits: two dimensions, straight edges. Cells of which nothing was asked stay stretched. A body's mesh does not
/// depend on the order of the bodies. One call costs O(cells) a halving asked for at most.
class Bisection
{
public:
  /// Sound triangle meshes (checkMesh). A facet has at most one twin.
  Bisection(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins);

  /// Halves every cell at least so often (it has 2^n descendants at least), and others as conformity needs.
  ///
  /// halvings: per mesh and cell of meshes(); not negative. Points keep their numbers and coordinates, new ones follow.
  /// Descendants stand where the cell stood, the parts of a side's facet where it stood, in the direction in which its
  /// cell goes round (counterclockwise). A swap leaves each of the two new cells in the place of one of the old.
  void refine(const std::vector<std::vector<int>>& halvings);

  const std::vector<Mesh>& meshes() const { return meshes_; } ///< refined so far, in the order given
  /// Per mesh and cell of meshes(): the cell before the last refine() in whose place it stands; it is a part of it
  /// unless its edges were swapped. Ascending.
  const std::vector<std::vector<int>>& parents() const { return parents_; }

private:
  /// A triangle meets its edges in the direction in which it goes round: number 2 * edge + direction. The two triangles
  /// of an edge meet it in opposite directions.
  using DirectedEdge = int;

  struct Triangle
  {
    std::array<int, 3> vertices;       ///< points of its mesh
    std::array<DirectedEdge, 3> edges; ///< the one opposite to each vertex
    int peak;                          ///< local vertex opposite to the refinement edge
    int parent;                        ///< cell of its mesh before refine() in whose place it stands
    int halvings;                      ///< still wanted
  };

  struct Edge
  {
    std::array<int, 2> slots{-1, -1}; ///< per direction: 3 * triangle + local edge, -1 at the boundary
    int child = -1;                   ///< its halves are the edges child and child + 1, in direction 0; -1: not halved
    int middle = -1;                  ///< the point of ...
    int middleMesh = -1;              ///< ... this mesh: that of the last triangle that was halved here
  };

  void addTriangles(const Mesh& mesh);
  void identify(const FacetTwin& twin);
  void choosePeaks();
  void linkEdges(int triangle);

  bool markWanted();
  void mark(DirectedEdge edge);
  void close();
  void halveMarked();
  void addDescendants(const Triangle& triangle, int mesh);
  void mendPeaks(int first, int mesh);
  int middleOf(const Triangle& triangle, int mesh);
  DirectedEdge childOf(DirectedEdge edge, int place) const;

  void swapEdges();
  double gainOfSwap(int edge) const;
  std::array<Triangle, 2> swapped(int edge) const;
  void swapEdge(int edge);
  int meshOf(int triangle) const;
  std::array<const double*, 3> cornersOf(const Triangle& triangle, int mesh) const;

  void writeMesh(int mesh);
  void addLeaves(DirectedEdge edge, std::vector<DirectedEdge>& leaves) const;

  std::vector<Mesh> meshes_;
  std::vector<std::vector<int>> parents_;
  std::vector<Triangle> triangles_; ///< of all meshes, one mesh after the other
  std::vector<int> begin_{0};       ///< first triangle of every mesh; one more entry
  std::vector<Edge> edges_;         ///< halved ones stay: sides and neighbours find the children through them
  std::vector<int> marked_;         ///< edges whose triangles the closure has still to visit
  std::vector<int> unchecked_;      ///< edges that may be worth swapping
  std::vector<std::vector<std::vector<DirectedEdge>>> sides_; ///< per mesh, side and facet
};

} // namespace ndframe
