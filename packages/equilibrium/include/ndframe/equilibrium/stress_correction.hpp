#pragma once

#include <vector>

#include "ndframe/equilibrium/static_data.hpp"

namespace ndframe
{

/// A stress in finite element equilibrium that is to be completed to an equilibrated one: sigma~ = K eps(u~), (40).
struct FieldInput
{
  const Vector* displacement = nullptr; ///< u~, numNodes * dim, global axes
  /// Tractions on StaticData::contact as shares: per contact facet, per facet vertex (ascending), per mode, per
  /// component: moments int t_a L_k. Null for bodies without contact.
  const Vector* contact = nullptr;
};

/// The equilibrated stress of a body is  sigma^ = K eps(u~) + c;  this is c, by what determines it: the moments of its
/// tractions on the facets of every cell (outward) and of its divergence. Inside the cell c minimises its energy.
struct StressCorrection
{
  int dim = 0, /**< of space */ degree = 0; ///< q of the stress
  Vector tractions;                         ///< per cell, facet (sorted), mode, component: int (c n) . L_k, a force
  Vector loads;                             ///< per cell, load mode, component: int (div c) m_k, a force

  /// Largest wrench of a star (moments over its size) that had no support to take it; of a cell after settleBalance().
  double imbalance = 0.0;
  double force = 0.0; ///< largest force in a star: what its data and sigma~ amount to
  /// Round-off when sigma~ is in finite element equilibrium with the data. Not relative to each star's own forces:
  /// where the body is free of stress these are round-off themselves.
  double defect() const { return force > 0.0 ? imbalance / force : 0.0; }
};

} // namespace ndframe
