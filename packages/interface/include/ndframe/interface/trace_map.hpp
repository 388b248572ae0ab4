#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/assembly/dof_layout.hpp"

namespace ndframe
{

/// y = A x + b.
struct AffineRows
{
  std::vector<SparseRow> rows; ///< A: one row per entry of y, columns by entries of x
  Vector offset;               ///< b: one entry per row

  /// A (B y + b') + b of x = B y + b'.
  AffineRows after(const AffineRows& inner) const;
};

/// A^-1 (y - b) of a matrix that is triangular in some order. Each row has its diagonal first.
AffineRows inverseOf(const AffineRows& map);

/// How a body's values on the interfaces depend on its kept dofs s: u_N = A s + b. A value is the displacement along
/// n_c at a node, or a coefficient made of those (ContactBasis). A is square and has as sparse an inverse.
class TraceMap
{
public:
  TraceMap() = default;
  /// Of the normal displacements themselves.
  explicit TraceMap(const std::vector<TraceDof>& trace);
  /// Of values u' = B u_N + b; what inverseOf says of rows holds for B, too.
  TraceMap(const std::vector<TraceDof>& trace, const AffineRows& coefficients);

  int size() const { return int(map_.rows.size()); }                 ///< number of values, as many as kept dofs
  const std::vector<int>& dofs() const { return dofs_; }             ///< the kept dofs
  const std::vector<SparseRow>& rows() const { return map_.rows; }   ///< A
  const std::vector<SparseRow>& inverse() const { return inverse_; } ///< A^-1
  const Vector& offset() const { return map_.offset; }               ///< b
  Vector values(const Vector& kept) const;                           ///< A s + b
  Vector keptValues(const Vector& values) const;                     ///< A^-1 (u_N - b)
  Vector keptForces(const Vector& forces) const;                     ///< A^T r: on the kept dofs
  Vector forces(const Vector& keptForces) const;                     ///< A^-T f
  /// The same seen along -n_c.
  void exchange();
  /// The same A, whatever b.
  bool isLike(const TraceMap& other) const;

private:
  std::vector<int> dofs_;
  AffineRows map_;
  std::vector<SparseRow> inverse_;
};

} // namespace ndframe
