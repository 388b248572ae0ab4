#pragma once

#include <array>
#include <vector>

#include "ndframe/adaptivity/prediction.hpp"
#include "ndframe/adaptivity/singular_place.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Per body and vertex: a unit vector, or zero.
using EdgeDirections = std::vector<std::vector<std::array<double, 3>>>;

/// Contributions of cells that have been measured, and how those of their parts will be.
///
/// A part of measure a at the distance d of its centre from a corner (in space: an edge) with u ~ r^lambda has
///   eta^2 = eta_K^2 (a / A)^(1 + 2 p / dim) (d / D)^(2 (lambda - 1 - p)),
/// A and D those of the cell K, which touches it. Where the solution is smooth the last factor is 1.
///
/// Of meshes made anew cells stand for their neighbourhood: measures of cells beside each other scatter, their
/// contributions much less, and sums of (a / A)^(1 + 2 p / dim) would be too large by a third. The measure is the
/// geometric mean around the vertices, averaged over them. Distances of centres scatter, too: contributions of cells
/// that touch an edge fall like D^-1 to D^-2 at equal volume (1500 cells), not like D^-4.6, and the sum would be too
/// large by up to a half. There D is 1.05 times the cube root of the volume, and d at least that of the part.
class ContributionModel
{
public:
  /// contributions: eta_K per body and cell of the meshes. exponents: lambda per body and vertex. directions: in space,
  /// of the edge on which a vertex lies.
  ContributionModel(const std::vector<Mesh>& meshes, const std::vector<Vector>& contributions,
                    const std::vector<Vector>& exponents, int degree, const EdgeDirections& directions = {},
                    bool areMadeAnew = false);

  /// A cell whose contribution was measured.
  struct Cell
  {
    CellDecay decay;        ///< of its contribution
    double measure;         ///< A, area or volume
    bool atPlace;           ///< touches a corner or edge, with the two following
    SingularPlace place;    ///< that
    double squaredDistance; ///< of the centre from it
  };

  const std::vector<std::vector<Cell>>& cells() const { return cells_; } ///< per body and cell of its mesh
  std::vector<std::vector<CellDecay>> decays() const;                    ///< of cells()
  ErrorDecay decay() const { return decay_; }                            ///< of smooth solutions
  bool areMadeAnew() const { return areMadeAnew_; }                      ///< cells may also grow on the next mesh

  /// sqrt(sum eta^2) on other meshes of the bodies. ancestors: per mesh and cell, that of cells() which it is part of.
  double errorOn(const std::vector<Mesh>& meshes, const std::vector<std::vector<int>>& ancestors) const;

private:
  Vector measuresOf(const Mesh& mesh) const;
  double logSquared(const Cell& cell, double measure, const std::array<double, 3>& centre) const;

  ErrorDecay decay_;
  bool areMadeAnew_;
  std::vector<std::vector<Cell>> cells_;
};

} // namespace ndframe
