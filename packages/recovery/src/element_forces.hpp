#pragma once

#include "ndframe/equilibrium/element_circulation.hpp"
#include "ndframe/equilibrium/element_edges.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// What sigma~ = K eps(u~) and the loads do to the displacements' nodal functions phi_i, cell by cell.
struct ElementForces
{
  int edgeNodes = 0;            ///< order + 1: the vertices of an edge, ascending, then its middle
  std::vector<Force> tractions; ///< per half edge and edge node: int_e (sigma~ n) phi_i, n outward
  /// Per cell, 3 * order nodes: the sorted vertices, then the middle of the edge opposite to each:
  /// - int_E (b + div sigma~) phi_i.
  std::vector<Force> residual;
  Vector loads; ///< StressCorrection::loads, - int_E (b + div sigma~) m_k
};

/// int_E b phi_i is taken from the shares of b, so that cells balance exactly for the data that stresses have to carry.
ElementForces nodalForces(const EdgeMap& edges, const BodyModel& body, const StaticData& data,
                          const Vector& displacement);

/// The tractions prescribed on the edges of the boundary, contact included.
class BoundaryTractions
{
public:
  BoundaryTractions(const Mesh& mesh, const StaticData& data, const Vector* contact);

  /// Directions (unit, orthogonal) along which the traction on a boundary half edge is given: those without support.
  const std::vector<Force>& given(int half) const { return entry(half).given; }
  /// The part of a force along these.
  Force givenPart(int half, Force force) const;
  /// int_e p L_k; zero on free edges.
  Force moment(int half, int mode) const { return entry(half).moments[std::size_t(mode)]; }

private:
  struct Entry
  {
    std::vector<Force> given, moments;
  };
  const Entry& entry(int half) const { return entries_[std::size_t(place_[std::size_t(half)])]; }
  Entry& makeEntry(const Mesh& mesh, Facet facet);
  static void addShares(const double* shares, Entry& entry);

  std::vector<int> place_;     ///< per half edge
  std::vector<Entry> entries_; ///< the first: free of traction
};

} // namespace ndframe
