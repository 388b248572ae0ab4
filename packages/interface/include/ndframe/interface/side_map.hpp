#pragma once

#include <array>
#include <utility>
#include <vector>

#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// An edge of a side's polygon in the plane; the body lies to the left of the way from its first to its second end.
struct SideEdge
{
  std::array<Direction, 2> ends;    ///< vertices of the polygon
  std::array<Direction, 2> normals; ///< n at the ends, linear in between (normal_field.hpp)
  bool turns = false;               ///< false: `normals` are the edge's own
  Direction bulge{};   ///< from the middle to the curve that the polygon stands for; zero where it does not turn
  double unsure = 0.0; ///< how far the curve may be elsewhere: a quarter of the largest bulge here and next to here

  Direction at(double place) const; ///< point of the straight edge, place from 0 to 1
  /// The curve: at(place) + 4 place (1 - place) bulge, which turns with `normals`.
  Direction onCurve(double place) const;
  double length() const; ///< of the straight edge
};

/// A stretch of a facet along an edge of a polygon, by places on the edge from 0 to 1; edge -1: it lies on none.
struct Stretch
{
  int edge = -1; ///< number in SidePolygon::edges()
  /// Place of the first vertex; it may be the larger one.
  double from = 0.0, to = 0.0; ///< of the facet's first and second vertex (facetVertices)
};

/// What a side of a triangle mesh looks like, apart from how it is meshed where it is straight: facets in line are one
/// edge unless n turns along them.
class SidePolygon
{
public:
  /// cornerAngle: as in turnNormals; 0 for a side whose normals do not count.
  SidePolygon(const Mesh& mesh, const std::vector<Facet>& facets, double cornerAngle);
  explicit SidePolygon(std::vector<SideEdge> edges) : edges_(std::move(edges)) {} ///< taken as they are

  const std::vector<SideEdge>& edges() const { return edges_; } ///< not sorted along the side
  /// Where a facet lies that is a part of an edge (up to 1e-6 of the facet).
  Stretch locate(const Mesh& mesh, Facet facet) const;

private:
  std::vector<SideEdge> edges_;
};

/// A part of the first side and the part of the second one that it may touch: x = first edge at (1 - t) first[0] +
/// t first[1], pi x = second edge at (1 - t) second[0] + t second[1]. n is linear in t, too.
struct SideSegment
{
  /// Number of an edge of the first polygon.
  int firstEdge = 0, secondEdge = 0; ///< number of an edge of the second polygon
  /// Places on the first edge at t = 0 and t = 1, ascending.
  std::array<double, 2> first{}, second{}; ///< places on the second edge that face those
};

/// Which points of two sides in the plane face each other: pi of docs/theory.md, section "Sides that do not match".
///
/// pi x is where the ray from x along n(x) meets the second side, at the ends of the segments; in between pi is affine.
/// A segment ends where an edge of either polygon ends. Points without partner (no edge that faces them on their ray)
/// are in no segment; points of the second side that two rays meet belong to the nearer segment.
///
/// Limits: two dimensions; edges face each other when they enclose less than 60 degrees.
/// Costs edges times edges, cheap ones: 1e4 edges a side take a second.
class SideMap
{
public:
  SideMap(SidePolygon first, SidePolygon second); ///< finds the segments

  const SidePolygon& first() const { return first_; }                    ///< side that has the normals n
  const SidePolygon& second() const { return second_; }                  ///< side that the rays meet
  const std::vector<SideSegment>& segments() const { return segments_; } ///< by ascending firstEdge

  /// The polygons themselves, or the curves that they stand for.
  enum class Shape
  {
    Polygons,
    Curves
  };

  Direction pointOnFirst(const SideSegment& segment, double t) const;  ///< x, for t from 0 to 1
  Direction pointOnSecond(const SideSegment& segment, double t) const; ///< pi x
  Direction normal(const SideSegment& segment, double t) const;        ///< n at x; not of length 1 where it turns
  /// pi x - x.
  Direction apart(const SideSegment& segment, double t, Shape shape) const;
  /// n . (pi x - x), negative where the bodies overlap.
  double opening(const SideSegment& segment, double t, Shape shape) const;
  /// Both edges straight, with their own normals, and the same line (up to 1e-9 of their length).
  bool isSameLine(const SideSegment& segment) const;
  /// No opening and no overlap but for what the curves are not known to (SideEdge::unsure).
  bool touches() const;
  /// Largest opening or overlap of the polygons, 0 for round-off.
  double largestOpening() const;
  /// The deepest overlap: a negative opening, with its place on the first side; 0 for round-off.
  std::pair<double, Direction> deepestOverlap(Shape shape) const;
  /// What is to be taken for the bodies' outlines: curves unless these overlap where the polygons do not (corners that
  /// are taken for a curve).
  Shape outlines() const;

private:
  void addSegments(int firstEdge);
  void keepApart();

  SidePolygon first_, second_;
  std::vector<SideSegment> segments_;
  double reach_ = 0.0; ///< no ray is longer
};

/// A piece of two facets that face each other: ends by place on the facets, from 0 at their first vertex to 1.
struct FacingPiece
{
  std::size_t segment;      ///< number in SideMap::segments()
  std::array<double, 2> at; ///< t on the segment
  /// Facet of the first mesh.
  Facet first, second; ///< facet of the second mesh
  /// Places of both ends on the first facet, in the order of `at`.
  std::array<double, 2> onFirst, onSecond; ///< places on the second facet
};

/// The common refinement of two meshes of the map's sides: pieces between neighbouring vertices of either mesh. Places
/// nearer than 1e-5 of the shorter facet are one. Empty where a facet does not lie on the polygons.
std::vector<FacingPiece> facingPieces(const SideMap& map, const Mesh& first, const std::vector<Facet>& firstFacets,
                                      const Mesh& second, const std::vector<Facet>& secondFacets);

} // namespace ndframe
