#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "ndframe/fem/moment_basis.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A basis at the points of samples on a simplex, padded (point_sums.hpp).
struct BasisTables
{
  std::vector<double> weighted; ///< weight m_k, a row a point
  std::vector<double> values;   ///< m_k, a row a function
  std::vector<double> weights;  ///< of the points
};

/// The tables of one basis. Most simplices are one piece, so that their points are those of a rule with the vertices in
/// one of a few orders: these tables are kept.
class SampledBasis
{
public:
  explicit SampledBasis(MomentBasis basis) : basis_(std::move(basis)) {}

  const MomentBasis& basis() const { return basis_; } ///< whose functions the rows belong to
  int size() const { return basis_.size(); }          ///< number of functions
  /// places: where the vertices that the samples refer to stand for the basis. Valid until the next call.
  const BasisTables& at(const Samples& samples, const std::array<int, 4>& places = {0, 1, 2, 3});
  /// At the points of a rule, in the basis's own order of the vertices.
  BasisTables at(const QuadratureRule& rule) const { return make(rule, {0, 1, 2, 3}); }

private:
  BasisTables make(const QuadratureRule& rule, const std::array<int, 4>& places) const;

  MomentBasis basis_;
  std::map<std::pair<const QuadratureRule*, std::array<int, 4>>, BasisTables> known_;
  BasisTables many_; ///< of the last simplex that is not one piece
};

} // namespace ndframe
