#pragma once

#include <optional>

#include "ndframe/equilibrium/cell_energy.hpp"

namespace ndframe
{

/// Turns stresses into strains.
DenseCholesky stiffnessFactor(const Elasticity& law);

/// The energy of one cell's stress in reference axes: x^T dd x + 2 y^T bd x + y^T bb y for data x and bubbles y.
class CellForm
{
public:
  CellForm(const ReferenceStress& reference, const CellMap& map, const Elasticity& law); ///< reference must outlive it

  /// The data's matrix once the bubbles take the least energy.
  DenseMatrix condensed() const;
  /// Coefficients of the stress of least energy with the given data.
  Vector coefficients(const Vector& data) const;

private:
  const ReferenceStress& reference_;
  std::vector<double> compliance_;
  DenseMatrix bd_;
  std::optional<DenseCholesky> bb_; ///< empty without bubbles
};

/// A correction without data.
StressCorrection zeroCorrection(const Mesh& mesh, int degree);

/// A correction's data in one cell as the reference simplex sees them: F^-1 applied to each vector.
Vector pullBack(const ReferenceStress& reference, const CellMap& map, const StressCorrection& correction, int cell);

} // namespace ndframe
