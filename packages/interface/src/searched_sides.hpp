#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ndframe/interface/facing_search.hpp"

namespace ndframe
{

/// An upright rectangle.
struct PlaneBounds
{
  std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

  void add(const double* point);
  void add(const PlaneBounds& other);
  /// Whether some of it is within the distance of the other one, in every direction.
  bool isNear(const PlaneBounds& other, double distance) const;
};

PlaneBounds boundsOf(const SideEdge& edge);

/// How far the curve that an edge stands for may be from it, with round-off.
double uncertainty(const SideEdge& edge);

/// What a part of a body's boundary is to the search.
enum class PartKind
{
  Named,
  Unnamed,
  LeftOut ///< hides what is behind it, and nothing else
};

/// A part of a body's boundary; parts have no facet in common.
struct SearchedPart
{
  int body;
  PartKind kind;
  std::string side; ///< of a named one
  std::vector<Facet> facets;
  PlaneBounds bounds;
  std::vector<SideEdge> edges; ///< of its polygon, where that was made
  std::vector<PlaneBounds> edgeBounds;
  double length = 0.0; ///< of the edges
  double unsure = 0.0; ///< largest uncertainty of an edge
};

/// The boundaries of all bodies in parts, without edges.
std::vector<SearchedPart> partsOf(const std::vector<SearchedBody>& bodies);

void makeEdges(SearchedPart& part, const Mesh& mesh, double cornerAngle);

} // namespace ndframe
