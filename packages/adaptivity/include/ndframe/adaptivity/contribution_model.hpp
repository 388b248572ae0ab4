#pragma once

#include <array>
#include <vector>

#include "ndframe/adaptivity/prediction.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Contributions of cells that have been measured, and how those of their parts will be.
///
/// A part of area a at the distance d of its centre from a corner with u ~ r^lambda has
///   eta^2 = eta_K^2 (a / A)^(p+1) (d / D)^(2 (lambda - 1 - p)),
/// A and D those of the cell K, which touches the corner. Where the solution is smooth the last factor is 1.
class ContributionModel
{
public:
  /// contributions: eta_K per body and cell of the meshes. exponents: lambda per body and vertex.
  ContributionModel(const std::vector<Mesh>& meshes, const std::vector<Vector>& contributions,
                    const std::vector<Vector>& exponents, int degree);

  struct Cell
  {
    CellDecay decay;
    double area;
    bool atCorner;
    std::array<double, 3> corner; ///< with the three following: of cells at a corner
    double squaredDistance;       ///< of the centre from the corner
  };

  const std::vector<std::vector<Cell>>& cells() const { return cells_; }
  std::vector<std::vector<CellDecay>> decays() const;
  int degree() const { return degree_; }

  /// sqrt(sum eta^2) on other meshes of the bodies. ancestors: per mesh and cell, that of cells() which it is part of.
  double errorOn(const std::vector<Mesh>& meshes, const std::vector<std::vector<int>>& ancestors) const;

private:
  double logSquared(const Cell& cell, double area, const std::array<double, 3>& centre) const;

  int degree_;
  std::vector<std::vector<Cell>> cells_;
};

} // namespace ndframe
