#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// Rows B v = c solved for one variable each, the pivots:  v_p = value - sum of others.  Gauss-Jordan elimination with
/// the largest coefficient of a row as pivot; rows that follow from others are left out.
///
///   B^T r = q  gives back the forces r of the rows from a q that has no part along what stays free.
///
/// Cost: that of the rows that share variables; a few each where rows are contact conditions at nodes.
class ClosedRows
{
public:
  /// rows: all rows; chosen: those that hold, in the order in which they take precedence; values: c of all rows.
  ClosedRows(const std::vector<SparseRow>& rows, const std::vector<int>& chosen, const Vector& values,
             int numVariables);

  /// Numbers of the variables that stay free, -1 at pivots.
  const std::vector<int>& freeNumber() const { return freeNumber_; }
  int numFree() const { return numFree_; } ///< number of variables that are no pivots

  /// The rows chosen but those that follow from others.
  const std::vector<int>& independentRows() const { return independent_; }

  /// v from the free variables' values.
  Vector expanded(const Vector& free) const;
  /// The same without the values c: Z y.
  Vector direction(const Vector& free) const;
  /// Z^T q.
  Vector reduced(const Vector& q) const;
  /// A variable as a combination of free ones (by their numbers).
  SparseRow inFree(int variable) const;
  /// r per row; 0 for rows that were not chosen, or follow from others.
  Vector forces(const Vector& q) const;

private:
  struct Reduced
  {
    int pivot;
    SparseRow others;      ///< of pivot + sum others = value; free variables only
    SparseRow combination; ///< of the rows given
    double value;
  };
  void add(int row, const SparseRow& entries, double value);
  void use(const Reduced& known, double factor, Reduced& row);
  void addWithKnown(const SparseRow& entries, Reduced& next);

  std::vector<Reduced> rows_;
  std::vector<int> independent_;
  std::vector<int> rowOf_;                ///< per variable: the row whose pivot it is, or -1
  std::vector<std::vector<int>> readers_; ///< per variable: rows in whose `others` it may stand
  std::vector<int> freeNumber_;
  int numFree_ = 0;
  std::size_t numRows_;
  std::vector<int> columnPlaces_, rowPlaces_; ///< all -1 but while a row grows
};

} // namespace ndframe
