#pragma once

#include <vector>

#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/equilibrium/static_data.hpp"
#include "ndframe/sampling/sampled_basis.hpp"

namespace ndframe
{

/// The shares of a load on one simplex and what they leave over.
struct SimplexMoments
{
  std::vector<double> shares; ///< per vertex (ascending), mode, component: int q_a m_k
  /// Moments of q - q_h, q_h the sum of the shares, in the finer basis that richer stresses carry (mode by mode); empty
  /// when they are round-off.
  std::vector<double> beyond;
  double beyondNorm = 0.0; ///< what they amount to in L2
  /// Bounds of what is left in L2, of its part that is orthogonal to the finer basis and of the others, which are not
  /// known to be; 0 when they are round-off.
  double rest = 0.0, others = 0.0;
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

  /// Valid until the next call.
  const SimplexMoments& of(const LoadedSimplex& simplex);

private:
  LoadMoments(int dim, int order, const MomentBasis& basis, const MomentBasis& fine, int carried);
  void testByHats();
  void addShares(std::size_t size);
  double takeSamples(const LoadedSimplex& simplex);
  double takeProjection(const LoadedSimplex& simplex);
  void addRemainder(const LoadedSimplex& simplex, double rest);
  bool isOrthogonalToAll(const LoadedSimplex& simplex) const;
  void spreadForces();

  int dim_, order_; ///< of the body
  bool isPiecewise_;
  /// tested: what hat functions are multiplied with. all: `fine` and these products; it begins with `fine`.
  MomentBasis basis_, tested_, fine_;
  SampledBasis all_;
  std::vector<double> ofHats_; ///< per vertex, mode of `tested`: its product with the hat function in terms of `all`
  std::size_t carried_; ///< functions of `fine` that the shares carry (of their affine twin when piecewise constant)
  Shares unit_;
  SimplexMoments result_;
  std::vector<double> forces_, moments_, rows_, scaled_; ///< at the vertices, of `all`, at the points; by the measure
};

} // namespace ndframe
