#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/interface/contact_role.hpp"
#include "ndframe/interface/interface_settings.hpp"
#include "ndframe/interface/obstacle.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// One of the two sides of an interface.
struct InterfaceSide
{
  int body = 0;              ///< index into the list of bodies
  std::vector<int> nodes;    ///< per interface node, node numbers in the body
  std::vector<Facet> facets; ///< per facet of the interface, on the body's mesh
};

/// n_c at the vertices of a facet, in their order; in the plane it has two.
using VertexNormals = std::array<Direction, 3>;

/// Two sides that may touch, whose meshes match: each facet has one that it faces. Everything is seen from the
/// Dirichlet body: n_c = n_1.
///
/// Interface nodes are numbered along the first side, the Dirichlet side of the deck; facets refer to these numbers.
/// Sides that are drawn apart or as different polygons have two positions at a node, and the first side's measure.
struct InterfaceMesh
{
  std::string name; ///< of its list in Interfaces
  /// The Dirichlet side of the deck and the Neumann side; nodes at split corners, or that face two others, stand more
  /// than once.
  std::array<InterfaceSide, 2> sides;
  int dirichletSide = 0;          ///< number of the side whose body is the Dirichlet body: its outward normal is n_c
  int dim = 0;                    ///< of space, 2 or 3
  int order = 0;                  ///< of the elements, 1 or 2
  std::vector<double> points;     ///< dim per interface node, on the first side
  std::vector<double> partners;   ///< the same on the second side; empty: the same points
  std::vector<Direction> apart;   ///< pi x - x at the nodes as the outlines are drawn; empty: zero
  std::vector<Direction> normals; ///< n_c at the nodes: mean of the facets', weighted by their measure,
                                  ///< or the value of the turning field (normal_field.hpp)
  Vector gap;                     ///< g at the nodes, a length
  SampledFunction gapFunction;    ///< the deck's Gap on the first side: g, without what the geometry says
  Vector drawnGap;                ///< n . (pi x - x) at the nodes where it counts, a part of g; or empty
  std::vector<int> facets;        ///< interface nodes per facet, as facetLocalNodes has them on the first side
  std::vector<double> measures;   ///< of the facets, on the first side
  std::vector<Direction> facetNormals; ///< of the first side's facets, seen from the Dirichlet body as n_c
  /// n_c at the vertices of each facet, linear in between, where it turns along the facet; zero on facets that keep
  /// their own normal. Empty where nothing turns.
  std::vector<VertexNormals> endNormals;
  std::shared_ptr<const InterfaceMesh>
      firstMesh;                      ///< the side as drawn or first meshed, which gave the normals; null: this one
  std::shared_ptr<const SideMap> map; ///< in the plane which points face each other; null: sides match as drawn
  bool isCut = false;                 ///< the meshes were cut to match; each body is refined by itself
  bool isMortar = false;              ///< contact is asked in weighted means (MortarSpace)

  const InterfaceSide& dirichlet() const { return sides[std::size_t(dirichletSide)]; }   ///< the Dirichlet body's side
  const InterfaceSide& neumann() const { return sides[std::size_t(1 - dirichletSide)]; } ///< the Neumann body's side
  /// The side of the body in this role.
  const InterfaceSide& side(ContactRole role) const { return role == ContactRole::Dirichlet ? dirichlet() : neumann(); }
  int numNodes() const { return int(sides[0].nodes.size()); } ///< number of interface nodes
  int numFacets() const { return int(measures.size()); }      ///< number of pairs of facets
  int nodesPerFacet() const { return numFacets() == 0 ? 0 : int(facets.size()) / numFacets(); } ///< 0 without facets
  /// The nodesPerFacet() interface nodes of a facet.
  const int* nodesOf(int facet) const { return facets.data() + std::ptrdiff_t(facet) * nodesPerFacet(); }
  /// The sides are two of one body.
  bool touchesItself() const { return sides[0].body == sides[1].body; }
  /// Where a slit ends a node faces itself: nothing moves there against anything.
  bool facesItself(int node) const
  {
    return touchesItself() && sides[0].nodes[std::size_t(node)] == sides[1].nodes[std::size_t(node)];
  }
  /// dim coordinates of a node, on the first side.
  const double* point(int node) const { return points.data() + std::size_t(node) * std::size_t(dim); }
  /// Where the node of the body in this role is.
  const double* pointOf(ContactRole role, int node) const
  {
    return (role == ContactRole::Dirichlet) == (dirichletSide == 0) || partners.empty()
               ? point(node)
               : partners.data() + std::size_t(node) * std::size_t(dim);
  }
};

/// The vertices of two sides that lie on each other, first and second; empty unless each lies on one of the other side.
std::vector<std::pair<int, int>> commonVertices(const Mesh& first, const Side& firstSide, const Mesh& second,
                                                const Side& secondSide);

/// Whether vertices of two sides lie on each other, each on one, and so do the triangles of solids.
bool sidesMatch(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide);

/// Pairs the two sides named by an entry of Interfaces.
///
/// Throws InputError when a side does not exist; when the sides do not match (how many nodes, the largest distance and
/// where); when the bodies overlap (both on the same side of the interface, one side inside the other body, or a
/// negative gap: where and how much); when they are apart (the opening belongs into Gap).
///
/// surface: the second body is rigid and lies on these facets (addLayer).
InterfaceMesh pairSides(const InterfaceSettings& settings, const BodyModel& dirichlet, const BodyModel& neumann,
                        const ObstacleSurface* surface = nullptr);

/// The same for sides of solids that were cut (insertion.hpp): the facets that both have. Throws InputError when there
/// is none, with what is nearest.
InterfaceMesh pairCutSides(const InterfaceSettings& settings, const BodyModel& dirichlet, const BodyModel& neumann);

/// The same for sides whose meshes match along a map (insertion.hpp). more: what a rigid body adds to the gap
/// (ObstacleOutline::gap).
InterfaceMesh pairFacing(const InterfaceSettings& settings, const BodyModel& dirichlet, const BodyModel& neumann,
                         std::shared_ptr<const SideMap> map, const std::string& more = {});

/// Adds n . (pi x - x) to the gap of sides with a map, as "Gap From Geometry" wants it: Yes, No, or, Automatic, unless
/// the sides touch but for the chords of a curve (SideMap::touches). To be called when the nodes have their normals.
/// Throws InputError where the sides overlap, with the place and the depth.
void addDrawnGap(const InterfaceSettings& settings, InterfaceMesh& interface);

} // namespace ndframe
