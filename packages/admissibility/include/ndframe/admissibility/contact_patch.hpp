#pragma once

#include <map>
#include <vector>

#include "ndframe/admissibility/facet_functions.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// One side of a contact patch: a facet of a body.
struct PatchSide
{
  int body = 0;                       ///< in the list of bodies; the same on both sides where a body touches itself
  Facet facet{};                      ///< on the body's mesh
  std::array<int, 3> places{0, 1, 2}; ///< the body's vertices, ascending, by their places among the patch's
};

/// With which sign a side feels what acts along n_c: 1 on side 0, -1 on side 1.
constexpr double sideSign(std::size_t side)
{
  return side == 0 ? 1.0 : -1.0;
}

/// A piece of an interface: a simplex of dimension dim - 1 that is a facet of two meshes, the same one or (in the
/// plane) drawn apart. Tractions are forces per length or area of the interface's first side: t n_c on side 0, -t n_c
/// times the ratio of the two measures on side 1.
struct ContactPatch
{
  int dim = 2;                      ///< of space
  std::array<PatchSide, 2> sides{}; ///< first that of the Dirichlet body, then that of the Neumann body
  Direction normal{};               ///< n_c: outward normal of side 0
  double measure = 0.0;             ///< length or area, on the interface's first side
  FacetNodes nodes{}; ///< interface nodes: vertices (in any order), then (order 2) the middles (FacetEdges)
  FacetNodes pairs{}; ///< their pairs of body nodes: nodes, but for the second node of a corner the first
  bool turns = false; ///< n_c turns along the patch, linear between `ends`
  std::array<Direction, 3> ends{};   ///< n_c at the vertices (the first `dim` nodes) where it turns
  bool isDrawnApart = false;         ///< the distance of the two sides as they are drawn is a part of the gap
  std::array<Direction, 3> drawn{};  ///< then (in the plane) x1 - x2 at the nodes, of the displacements' order
  std::array<Direction, 3> points{}; ///< its vertices on the interface's first side

  std::size_t numVertices() const { return std::size_t(dim); } ///< those of a simplex of dimension dim - 1
  /// Of displacements of order 1 or 2.
  std::size_t numNodes(int order) const { return std::size_t(numFacetNodes(dim, order)); }
  /// Both sides are of one body.
  bool touchesItself() const { return sides[0].body == sides[1].body; }
  /// n_c at a node of the patch, in the order of `nodes`.
  Direction normalAt(std::size_t node) const;
};

/// A patch, seen from one of the bodies that meet there.
struct BodyPatch
{
  std::size_t patch; ///< in the list of patches
  std::size_t side;  ///< the body's side of it
};

/// The patches that a body takes part in, in their order; those where it touches itself twice, side 0 first.
std::vector<BodyPatch> patchesOfBody(const std::vector<ContactPatch>& patches, int body);

/// Of space; all patches have the same. 2 without any.
int dimOf(const std::vector<ContactPatch>& patches);

/// How the moments of a function follow when the vertices are taken in another order: L_k of the coordinates
/// lambda_places(0), lambda_places(1), .. has the mean values R(k, j) with L_j. On edges 1 and -1.
DenseMatrix modesInOrder(int dim, int degree, const std::array<int, 3>& places);

/// modesInOrder() for the sides of patches: every order is found once.
class OrderedModes
{
public:
  OrderedModes(int dim, int degree) : dim_(dim), degree_(degree) {} ///< dim: of space; degree: q
  const DenseMatrix& operator()(const PatchSide& side);             ///< R, as long as this object lives

private:
  int dim_, degree_;
  std::map<std::array<int, 3>, DenseMatrix> found_;
};

} // namespace ndframe
