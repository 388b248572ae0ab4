#pragma once

#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// Points of two sides are one when they are closer than this, relative to the shortest facet.
constexpr double samePoint = 1e-5;

/// The side that an interface names; InputError if the body has none of that name.
const Side& findSide(const InterfaceSettings& settings, ContactRole role, const BodyModel& body);

/// An interface of bodies like this one, still without facets.
InterfaceMesh emptyInterface(const std::string& name, const BodyModel& body);

/// The nodes of a side as an interface numbers them: in space by their coordinates, so that no numbering of meshes
/// counts, and ranks that have shares of bodies agree with those that have all of them; in the plane ascending.
std::vector<int> nodesInOrder(const NodeMap& nodes, const std::vector<Facet>& facets);

/// Fills in what an interface has of its first side alone: nodes (nodesInOrder), facets, and addNormals().
void addSideFacets(InterfaceMesh& interface, const Mesh& mesh, const NodeMap& nodes, const std::vector<Facet>& facets);

/// Fills in dirichletFacets, measures, facetNormals and the normals at the nodes (setMeanNormals).
void addNormals(InterfaceMesh& interface, const Mesh& mesh, const std::vector<Facet>& facets);

/// Makes the normals at the nodes the facets', weighted by their measure.
void setMeanNormals(InterfaceMesh& interface);

/// Fills in gapFunction and gap: the deck's Gap, and what an obstacle adds to it (ObstacleOutline::gap). InputError
/// where it is negative or not finite.
void evaluateGap(const InterfaceSettings& settings, InterfaceMesh& interface, const std::string& more = {});

} // namespace ndframe
