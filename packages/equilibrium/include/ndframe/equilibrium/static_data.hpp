#pragma once

#include <map>
#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// A boundary facet where something is prescribed.
struct BoundaryFacet
{
  Facet facet;                           ///< of the body's mesh
  int supported = 0;                     ///< number of independent directions that supports prescribe on this facet
  std::array<Direction, 3> directions{}; ///< these, orthonormal: the traction along them is a reaction, unknown

  /// Takes the parts along these directions out of `count` vectors of dim components, one after the other.
  void removeSupported(int dim, std::size_t count, double* vectors) const;
};

/// What an equilibrated stress of one body has to satisfy apart from contact:  div sigma + b = 0, sigma n = p  (36),
/// with b and p replaced by polynomials (RECOVERY of degree q), and what the replacement costs.
///
/// A star patch (vertex a) balances its share of the data; the shares of the vertices of a cell or facet add up to the
/// data's projection. Order 2: the projection of phi_a b and phi_a p. Order 1: the load of resultant int phi_a b acting
/// at a (docs/theory.md), so that stars are balanced although rotations times phi_a are not in the space.
struct StaticData
{
  int dim = 0, /**< of space */ order = 0, /**< p, of the displacements */ degree = 0; ///< q, of the stresses
  std::vector<BoundaryFacet> boundary; ///< facets with supports or loads; facets not listed are free of traction
  /// Shares of p: per boundary facet, per facet vertex (ascending), per mode, per component: moments int p_a L_k.
  std::vector<double> facetShares;
  /// Shares of b: per cell, per sorted vertex, per load mode, per component: moments int b_a m_k. Empty without body
  /// force.
  std::vector<double> cellShares;
  /// Facets whose traction comes with each field; in `boundary` too when supported or loaded.
  std::vector<Facet> contact;

  /// Bound of the data's oscillation, squared, per cell: |(b - b_h, v)_E + (p - p_h, v)_f| <= osc_E |v|_E in the energy
  /// norm, by constants (docs/theory.md has their sources) or sharper (sharpenOscillation). 0 when the data are carried
  /// to round-off.
  std::vector<double> oscillation;
  /// What a sharper bound is made of: tractions and loads of a stress of the richest degree that carries most of p -
  /// p_h and b - b_h (as in StressCorrection; tractions of facets, by cell and sorted facet, that have any), and per
  /// cell the constants' bound for |eps(v)| of what it leaves. All empty when the bound is that already.
  std::map<std::size_t, std::vector<double>> liftedTractions;
  std::vector<double> liftedLoads, rest;
  std::string caveat; ///< why the oscillation is not a proven bound in this run; empty when it is
};

/// How a star's share of a function follows from the function, on the reference simplex of dimension n (a facet or a
/// cell), for displacements of order p.
///
/// Order 2: share = projection of phi_a f onto the basis. Order 1: f is a constant; share = int phi_a f times the
/// function of the basis that acts like a unit force at vertex a (the dual of phi_a).
class Shares
{
public:
  Shares(const MomentBasis& basis, int order); ///< basis: of a facet or of loads; order p: 1 or 2
  /// Moments (per mode) of the share of vertex a of the function 1, divided by the simplex's measure.
  const double* ofOne(int a) const { return one_.data() + std::size_t(a) * std::size_t(modes_); }
  /// Order 2: moments of the share of vertex a of the barycentric coordinate lambda_b (b = 0..n), over the measure.
  const double* ofLinear(int a, int b) const;

private:
  int dim_ = 0, modes_ = 0;
  std::vector<double> one_, linear_;
};

} // namespace ndframe
