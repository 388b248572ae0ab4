#pragma once

#include "ndframe/equilibrium/reference_stress.hpp"

namespace ndframe
{

/// What CellForm finds, for many cells side by side, so that a cell costs little more than the elimination of its
/// bubbles. Reference axes (see ReferenceStress).
class CellForms
{
public:
  /// Cells of condensed().
  static constexpr int lanes = 8;

  explicit CellForms(const ReferenceStress& reference); ///< reference must outlive it

  /// CellForm::condensed of `lanes` cells, both per entry and lane.
  struct Condensed
  {
    const double* triangle; ///< lower triangle of the matrices, data x data, column by column
    const double* factor;   ///< factorSize() entries: what apply() needs of the bubbles
  };
  /// compliances: per entry (pulledBackCompliance) and lane. The result is valid until `work` is used again.
  Condensed condensed(const double* compliances, Vector& work) const;
  std::size_t factorSize() const; ///< entries a lane; 0 without bubbles

  /// Data of a facet up to linear tractions, which alone have a wrench.
  static constexpr int linear = 9;
  /// The parts of condensed() that facets have alone, and between the linear tractions of two; per entry and lane.
  struct Facets
  {
    const double* alone;  ///< facet by facet, lower triangle of its data x data, column by column
    const double* pairs;  ///< facets 01, 02, 03, 12, 13, 23: linear x linear, rows of the second, column by column
    const double* factor; ///< as of condensed()
  };
  /// The result is valid until `work` is used again.
  Facets facets(const double* compliances, Vector& work) const;

  /// forces = the same matrices times x, without having the matrices: the stress of x, its bubbles, and back; both
  /// have the tractions alone (`size` = their number) or all data. Per entry and lane.
  void apply(const double* compliances, const double* factor, const double* x, std::size_t size, double* forces) const;

  /// Numbers of `lanes` cells that applyRounded() needs.
  std::size_t roundedSize() const { return (reference_.energy.size() + factorSize()) * lanes; }
  /// Finds them from compliances and factor: for compliances times `scales`, one a lane, so that the largest is one.
  void round(const double* compliances, const double* factor, float* numbers, double* scales) const;
  /// apply() to tractions in single precision, for half the time, compliances times their scales. Relative round-off
  /// grows with the fourth power of the aspect ratio from 1e-7 on: for directions that an energy falls in, never for
  /// the energy.
  void applyRounded(const float* numbers, const float* T, float* forces) const;

  /// CellForm::coefficients: from compliances and data of `lanes` cells, per entry and lane.
  void leastStress(const double* compliances, const double* data, double* stress) const;

private:
  template <class Add>
  void addFacets(const Add& add);
  void findBubbles(const double* factor, const double* weighed, double* inside) const;

  const ReferenceStress& reference_;
  Vector lift_;             ///< of all data, row by row; functions are orthonormal on sub-cells
  Vector lifted_;           ///< the same, column by column
  Vector bubble_, bubbled_; ///< the same
  std::vector<float> liftRounded_, liftedRounded_, bubbleRounded_, bubbledRounded_; ///< lift_ of tractions alone
  Vector table_;      ///< per entry of the triangle of data, then of rows of bubbles, what compliances weigh
  Vector facetTable_; ///< the same per entry of Facets, then of the tractions' rows of bubbles and of bubbles
};

/// Those of solids whose stresses have this degree, 1 or 2; computed on first use, then kept.
const CellForms& solidForms(int degree);

} // namespace ndframe
