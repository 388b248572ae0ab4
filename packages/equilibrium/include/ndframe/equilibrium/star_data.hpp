#pragma once

#include "ndframe/equilibrium/cell_stress.hpp"
#include "ndframe/equilibrium/star_body.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// The data of a star's cells, one column a field: per cell the moments x = (T, G) in the order of ReferenceStress, on
/// all its facets, global axes.
using StarFields = DenseMatrix;

/// The stresses sigma~ of several fields and the loads on a body, divided among its stars.
class StarLoads
{
public:
  /// body and what `fields` point to must outlive it.
  StarLoads(const StarBody& body, std::vector<FieldInput> fields);

  /// What the star's share of the correction has to satisfy, before any spoke carries anything: rim zero, interior
  /// spokes T_1 = 0, T_2 = - share of the jump, boundary spokes share of p - sigma~ n (contact included; supported
  /// directions zero), G = - share of (b + div sigma~). Cells are not in balance yet.
  /// forces: per field those that sigma~ and the loads amount to in the star, to measure an imbalance with.
  StarFields initial(const Star& star, Vector& forces) const;

private:
  void addStress(const Star& star, int field, double* x) const;
  void addLoads(const Star& star, int field, double* x) const;
  void addShare(const Star& star, const Spoke& spoke, const double* shares, int index, double* x) const;

  const StarBody* body_;
  std::vector<FieldInput> fields_;
  Shares facetShares_, cellShares_;
};

/// Corrections of a body, one per field.
using BodyCorrections = std::vector<StressCorrection*>;

/// The current data of a star's cells, all shares together.
StarFields gather(const StarBody& body, const Star& star, const BodyCorrections& corrections);
/// Puts them back.
void scatter(const StarBody& body, const Star& star, const StarFields& x, const BodyCorrections& corrections);
/// Adds a star's own data to the sum.
void add(const StarBody& body, const Star& star, const StarFields& x, const BodyCorrections& corrections);

} // namespace ndframe
