#pragma once

#include <algorithm>
#include <memory>

#include "ndframe/algebra/sparse_columns.hpp"
#include "ndframe/algebra/symmetric_operator.hpp"
#include "network.hpp"

namespace ndframe
{

/// The bodies' own operators in a network: S, S^+ (or the inverse of S + proximal D), rigid motions R.
class NetworkBodies
{
public:
  /// The network must outlive it; its operators are stored.
  explicit NetworkBodies(const Network& network);

  int numMotions() const { return firstMotion_.back(); }
  /// D, the diagonal of S, per entry of v.
  const Vector& weight() const { return weight_; }
  /// D^-1.
  const Vector& softness() const { return softness_; }

  /// Makes S^+; with proximal > 0 the inverse of S + proximal D.
  void factor(double proximal);
  /// S v.
  Vector stiff(const Vector& v) const;
  /// g - S v - proximal D (v - centre).
  Vector unbalanced(const Vector& v, double proximal, const Vector& centre) const;
  /// S^+ f.
  Vector flexible(const Vector& f) const;
  /// R a and R^T f.
  Vector moved(const Vector& amplitudes) const;
  Vector work(const Vector& f) const;
  /// A R for a matrix A with `rows` rows, given by its columns.
  SparseColumns motionColumns(const std::vector<SparseRow>& columns, int rows) const;
  /// The a with R a nearest to v, body by body.
  Vector amplitudes(const Vector& v) const;

  /// apply(body, part) for every body whose part of v is not zero.
  template <class Apply>
  Vector bodyByBody(const Vector& v, const Apply& apply) const
  {
    Vector result(v.size(), 0.0);
    for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
      const auto first = v.begin() + network_.offsets[b], last = v.begin() + network_.offsets[b + 1];
      if (std::all_of(first, last, [](double x) { return x == 0.0; }))
        continue;
      const Vector own = apply(b, Vector(first, last));
      std::copy(own.begin(), own.end(), result.begin() + network_.offsets[b]);
    }
    return result;
  }

  /// The same for a v of few entries, in the time that its bodies take: take(entry, value) for what they give.
  template <class Apply, class Take>
  void bodyByBody(const SparseRow& v, const Apply& apply, const Take& take) const
  {
    const std::vector<int>& offsets = network_.offsets;
    for (auto entry = v.begin(); entry != v.end();) {
      const auto b = std::size_t(std::upper_bound(offsets.begin(), offsets.end(), entry->first) - offsets.begin()) - 1;
      Vector own(std::size_t(offsets[b + 1] - offsets[b]), 0.0);
      for (; entry != v.end() && entry->first < offsets[b + 1]; ++entry)
        own[std::size_t(entry->first - offsets[b])] = entry->second;
      const Vector result = apply(b, own);
      for (std::size_t k = 0; k < result.size(); ++k)
        take(std::size_t(offsets[b]) + k, result[k]);
    }
  }

private:
  const Network& network_;
  Vector weight_, softness_;
  std::vector<int> firstMotion_{0};
  double proximal_ = -1.0;
  std::vector<std::unique_ptr<SymmetricOperator>> shifted_;
  std::vector<std::unique_ptr<RestrictedInverse>> inverse_;
};

} // namespace ndframe
