#pragma once

#include <vector>

#include "ndframe/equilibrium/cell_energy.hpp"
#include "ndframe/equilibrium/star_topology.hpp"

namespace ndframe
{

/// A body as its stars see it: what all of them share. Model and data must outlive it.
class StarBody
{
public:
  StarBody(const BodyModel& model, const StaticData& data);

  const BodyModel& model() const { return model_; }
  const StaticData& data() const { return data_; }
  const ReferenceStress& reference() const { return reference_; }
  const VertexCells& around() const { return around_; }
  int dim() const { return data_.dim; }
  int facetModes() const { return reference_.facetModes; }
  int loadModes() const { return reference_.loadModes; }
  /// Moments of one facet: facetModes * dim.
  int facetData() const { return reference_.facetModes * data_.dim; }

  /// meanCoordinates of the facets' and the cells' bases.
  const Vector& facetMeans() const { return facetMeans_; }
  const Vector& cellMeans() const { return cellMeans_; }
  DenseMatrix cellEnergy(const StarCell& cell) const;

  /// The star of a vertex. Throws SelfTouching when its cells do not hang together through facets.
  Star star(int vertex) const;
  /// Number in StaticData::boundary and StaticData::contact; -1 when it is not there. facet: sorted.
  int boundaryIndex(int cell, int facet) const { return lookUp(boundary_, cell, facet); }
  int contactIndex(int cell, int facet) const { return lookUp(contact_, cell, facet); }

private:
  using Index = std::vector<std::pair<int, int>>; ///< (cell * (dim + 1) + facet, number), ascending
  int lookUp(const Index& index, int cell, int facet) const;

  const BodyModel& model_;
  const StaticData& data_;
  const ReferenceStress& reference_;
  VertexCells around_;
  Vector facetMeans_, cellMeans_;
  Index boundary_, contact_;
};

} // namespace ndframe
