#pragma once

#include "ndframe/cutting/split_facets.hpp"

namespace ndframe
{

struct OverlayManner
{
  double near;   ///< edges are led through vertices of the other side so near, relative to the edges there
  bool isSmooth; ///< points are moved within what leaves both bodies as they are, so that triangles become rounder
  bool ofRims = false; ///< only the first side is cut, where creases of the second one lie on it
};

/// Adds to the splits of two meshes what makes the facets of either side that overlap into common ones: vertices of
/// each side on the other one, points where edges cross, and triangles between them (constrainedTriangulation of each
/// plane, so that both meshes get the same ones).
///
/// Vertices within 1e-3 of the edges around them are one (where both must stay they keep their places). An edge inside
/// a flat part of a side (creases()) is led through vertices of the other side that are within `near` of the edges
/// there; others within 1e-3. One mesh may be both (a body that touches itself): then the splits are one, too. Throws
/// CannotCut where edges that are led through vertices would cross each other; a smaller `near` helps.
void overlay(const Mesh& first, const std::vector<Facet>& firstFacets, FacetSplits& firstSplits, const Mesh& second,
             const std::vector<Facet>& secondFacets, FacetSplits& secondSplits, const OverlayManner& manner);

} // namespace ndframe
