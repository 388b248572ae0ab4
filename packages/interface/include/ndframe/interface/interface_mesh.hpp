#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/assembly/adaptive_samples.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

/// Two matching sides that may touch. Everything is seen from the Dirichlet body: n_c = n_1.
///
/// Interface nodes are numbered along the Dirichlet side; facets refer to these numbers.
struct InterfaceMesh
{
  std::string name;
  int dirichletBody = 0, neumannBody = 0; ///< indices into the list of bodies
  int dim = 0;
  int order = 0;
  std::vector<int> dirichletNodes, neumannNodes; ///< per interface node, node numbers in the two bodies
  std::vector<double> points;                    ///< dim per interface node
  std::vector<Direction> normals;                ///< n_c at the nodes: mean of the facets', weighted by their measure,
                                                 ///< or the value of the turning field (normal_field.hpp)
  Vector gap;                                    ///< g >= 0 at the nodes, a length
  SampledFunction gapFunction;                   ///< g between them
  std::vector<int> facets;                       ///< interface nodes per facet, in the order of facetLocalNodes
  std::vector<double> measures;                  ///< of the facets
  std::vector<Facet> dirichletFacets, neumannFacets; ///< the same facet on the two sides
  /// n_c at the two vertices of each facet, linear in between, where it turns along the facet; zero on facets that keep
  /// their own normal. Empty where nothing turns.
  std::vector<std::array<Direction, 2>> endNormals;
  std::shared_ptr<const InterfaceMesh> firstMesh; ///< the side as first meshed, which gave the normals; null: this one

  int numNodes() const { return int(dirichletNodes.size()); }
  int numFacets() const { return int(measures.size()); }
  int nodesPerFacet() const { return numFacets() == 0 ? 0 : int(facets.size()) / numFacets(); }
  const double* point(int node) const { return points.data() + std::size_t(node) * std::size_t(dim); }
};

/// Pairs the two sides named by an `Interfaces` entry (keys "Dirichlet Side", "Neumann Side", "Gap", "Corner Angle").
///
/// Throws InputError when a side does not exist; when the sides do not match (how many nodes, the largest distance and
/// where); when the bodies overlap (both on the same side of the interface, one side inside the other body, or a
/// negative gap: where and how much); when they are apart (the opening belongs into Gap).
InterfaceMesh pairSides(const Params& definition, const BodyModel& dirichlet, const BodyModel& neumann);

} // namespace ndframe
