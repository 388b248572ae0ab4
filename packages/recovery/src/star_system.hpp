#pragma once

#include <vector>

#include "ndframe/equilibrium/star_balance.hpp"

namespace ndframe
{

/// The stresses on a star that keep its cells in balance and vanish on its rim, and the one among them of least energy.
///
/// Cells carry x = (T, G) (StarFields: a column per field). For x in balance the energy of
///
///   x + dx(z, dt),   z: inner unknowns (circulating wrenches, self-equilibrated modes, reactions), dt: released
///   tractions
///
/// is minimised over z; what is left is a quadratic function of dt:
///
///   min_z |x + dx|^2 = dt^T H dt + 2 h^T dt + const,   E dt = 0   (balance, supports at the star taken into account).
///
/// Initial pass: x = StarLoads::initial, then balance(x), then relax(x). Sweeps: x = gather(...), relax(x),
/// scatter(...). Only what is on the star changes; the tractions on the rim are kept. Moments and dt are forces.
class StarSystem
{
public:
  /// released: facets of this star where the traction along a direction may be chosen (contact); empty: none.
  StarSystem(const StarBody& body, Star star, const std::vector<ReleasedFacet>& released = {});

  const Star& star() const { return balance_.star(); }
  /// Length of dt: released facet by released facet, mode by mode (facetModes each, this body's ascending vertices).
  int numReleased() const { return balance_.numReleased(); }

  /// Adds to x what brings every cell into balance (supports take what they can). Returns per field the norm of the
  /// wrench that nothing takes (moments over the star's size); it stays in one cell.
  Vector balance(StarFields& x) const { return balance_.balance(x); }

  /// H, numReleased x numReleased.
  const DenseMatrix& stiffness() const { return stiffness_; }
  /// h, numReleased x fields.
  DenseMatrix gradient(const StarFields& x) const;
  /// E, rows x numReleased; rows may depend on each other or be zero.
  DenseMatrix conditions() const { return balance_.conditions(); }

  /// Moves x to the least energy, the released tractions changed by dt (numReleased x fields).
  void relax(StarFields& x, const DenseMatrix& dt) const;
  void relax(StarFields& x) const { relax(x, DenseMatrix(numReleased(), x.cols())); }

private:
  /// How the tractions on the spokes of a cell depend on the unknowns, and their energy.
  struct CellPart
  {
    std::vector<int> rows; ///< in the cell's data
    std::vector<int> unknowns;
    DenseMatrix columns; ///< rows x unknowns
    DenseMatrix energy;  ///< of all data of the cell
  };

  CellPart makePart(int cell) const;
  int numInner() const { return balance_.numUnknowns() - balance_.numReleased(); }
  void eliminateInner(const DenseMatrix& full);
  Vector solveInner(const double* gradient) const;
  DenseMatrix fullGradient(const StarFields& x) const;

  StarBalance balance_;
  std::vector<CellPart> parts_;
  Vector scale_;           ///< of the inner unknowns: their diagonal becomes one
  DenseCholesky inner_;    ///< over the scaled z
  DenseMatrix condensing_; ///< H_zz^-1 H_zt
  DenseMatrix stiffness_;
};

} // namespace ndframe
