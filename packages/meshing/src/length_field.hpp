#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/cell_locator.hpp"

namespace ndframe
{

/// A positive function on a mesh, given at its vertices and linear in every cell. Beyond the mesh (a curved
/// boundary lies beside its chords) it is that of the nearest point.
class LengthField
{
public:
  /// The mesh must outlive the field.
  LengthField(const Mesh& mesh, std::vector<double> lengths);

  const Mesh& mesh() const { return mesh_; }
  const std::vector<double>& lengths() const { return lengths_; }
  void setLengths(std::vector<double> lengths) { lengths_ = std::move(lengths); }

  double at(const std::array<double, 3>& point) const;

private:
  const Mesh& mesh_;
  CellLocator cells_;
  std::vector<double> lengths_;
};

/// Lengths at the vertices of a mesh made smaller where they grow by more than `slope` per distance along an edge: gmsh
/// makes bad cells where sizes jump.
std::vector<double> withLimitedGrowth(const Mesh& mesh, std::vector<double> lengths, double slope);

} // namespace ndframe
