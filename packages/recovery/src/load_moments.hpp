#pragma once

#include <map>
#include <tuple>

#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/recovery/static_data.hpp"

namespace ndframe
{

/// The shares of a load on one simplex and what they leave over.
struct SimplexMoments
{
  std::vector<double> shares; ///< per vertex (ascending), mode, component: int q_a m_k
  /// Moments of q - q_h, q_h the sum of the shares, in the finer basis that richer stresses carry (mode by mode); empty
  /// when they are round-off.
  std::vector<double> beyond;
  /// Bound of what is left in L2; 0 when it is round-off.
  double rest = 0.0;
};

/// A basis at the points of samples, in barycentric coordinates for the vertices in ascending order.
struct BasisSamples
{
  int dim = 0, modes = 0;
  std::vector<double> lambda, values; ///< per point
};

/// Moments of loads on the simplices of one kind, from the samples that the load vector is made of: facets with
/// facetBasis, cells with loadBasis.
///
/// Order 2: shares int phi_a q m_k. Order 1: int phi_a q times the function that acts like a unit force at a.
class LoadMoments
{
public:
  /// fine: degree of the stresses that carry what is beyond; the degree itself when none do.
  static LoadMoments onFacets(int dim, int order, int degree, int fine);
  static LoadMoments inCells(int dim, int order, int degree, int fine);

  SimplexMoments of(const LoadedSimplex& simplex) const;

private:
  LoadMoments(int dim, int order, const MomentBasis& basis, const MomentBasis& fine, int carried, bool isPiecewise);
  std::vector<double> sharesOf(const LoadedSimplex& simplex) const;
  void addRemainder(const LoadedSimplex& simplex, SimplexMoments& moments) const;

  const BasisSamples& samplesOf(const LoadedSimplex& simplex, const MomentBasis& basis, int number) const;

  int dim_, order_; ///< of the body
  bool isPiecewise_;
  MomentBasis basis_, constant_, fine_;
  std::size_t carried_; ///< functions of `fine` that the shares carry (of their affine twin when piecewise constant)
  Shares unit_;
  /// By the number of the basis, the rule and the order of the vertices.
  mutable std::map<std::tuple<int, const QuadratureRule*, std::array<int, 4>>, BasisSamples> known_;
  mutable std::array<BasisSamples, 3> many_; ///< of the last simplex that is not one piece
};

} // namespace ndframe
