#pragma once

#include <map>
#include <set>
#include <string>

#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{

/// The vertices of one body's side that may be moved along it: not where it turns, nor where any named side ends.
class LooseVertices
{
public:
  LooseVertices(Mesh& mesh, const std::string& side);

  double shortestFacetAt(int vertex) const { return shortest_.at(vertex); }
  void keep(int vertex) { fixed_.insert(vertex); }

  /// Moves a vertex along its side; false where it must stay, or where a cell would lose half of its area.
  bool move(int vertex, const double* to);

private:
  void keepCorners(const std::string& side);

  Mesh& mesh_;
  VertexCells cells_;
  std::set<int> fixed_;
  std::map<int, double> shortest_; ///< per vertex of the side, its shorter facet
};

} // namespace ndframe
