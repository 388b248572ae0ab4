#include "moved_set.hpp"

#include <utility>

namespace ndframe
{
namespace
{

constexpr double singular = 1e-8; ///< of A's diagonal: what is left of it in W is lost in round-off

void subtract(Vector& y, double factor, const Vector& column)
{
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] -= factor * column[i];
}

} // namespace

MovedSet::MovedSet(const DenseMatrix& A, const DenseCholesky& factor, std::vector<int> places, double shift)
    : A_(A), factor_(factor), places_(std::move(places)), shift_(shift), columnOf_(places_.size(), -1)
{}

bool MovedSet::moveTo(const std::vector<char>& isFree, int most)
{
  std::vector<int> removedRows, addedRows, missing;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if ((places_[i] >= 0) == (isFree[i] != 0))
      continue;
    (isFree[i] ? addedRows : removedRows).push_back(int(i));
    if (columnOf_[i] < 0)
      missing.push_back(int(i));
  }
  if (int(Y_.size() + missing.size()) > most)
    return false;
  addColumns(missing);
  std::vector<int> removed, added;
  for (const int row : removedRows)
    removed.push_back(columnOf_[std::size_t(row)]);
  for (const int row : addedRows)
    added.push_back(columnOf_[std::size_t(row)]);
  DenseMatrix G = gram(removed, added), W = gram(added, added);
  try {
    DenseCholesky N(gram(removed, removed));
    const DenseMatrix half = N.solveLower(G), inner = multiplyTransposed(half, half);
    for (int j = 0; j < W.cols(); ++j)
      for (int i = 0; i < W.rows(); ++i)
        W(i, j) =
            A_(addedRows[std::size_t(i)], addedRows[std::size_t(j)]) + (i == j ? shift_ : 0.0) - W(i, j) + inner(i, j);
    for (int i = 0; i < W.rows(); ++i)
      if (const int row = addedRows[std::size_t(i)]; !(W(i, i) > singular * (A_(row, row) + shift_)))
        return false;
    W_.emplace(std::move(W));
    N_.emplace(std::move(N));
  } catch (const NotPositiveDefinite&) {
    return false;
  }
  G_ = std::move(G);
  removed_ = std::move(removed);
  added_ = std::move(added);
  return true;
}

/// L^-1 of unit vectors, of columns of A.
void MovedSet::addColumns(const std::vector<int>& rows)
{
  DenseMatrix U(factor_.size(), int(rows.size()));
  for (int j = 0; j < U.cols(); ++j) {
    const int row = rows[std::size_t(j)];
    if (const int place = places_[std::size_t(row)]; place >= 0)
      U(place, j) = 1.0;
    else
      for (std::size_t i = 0; i < places_.size(); ++i)
        if (places_[i] >= 0)
          U(places_[i], j) = A_(int(i), row);
  }
  U = factor_.solveLower(std::move(U));
  for (int j = 0; j < U.cols(); ++j) {
    columnOf_[std::size_t(rows[std::size_t(j)])] = int(Y_.size());
    rows_.push_back(rows[std::size_t(j)]);
    Y_.push_back(U.column(j));
  }
}

DenseMatrix MovedSet::gram(const std::vector<int>& left, const std::vector<int>& right) const
{
  DenseMatrix result(int(left.size()), int(right.size()));
  for (int j = 0; j < result.cols(); ++j)
    for (int i = 0; i < result.rows(); ++i)
      result(i, j) = dot(Y_[std::size_t(left[std::size_t(i)])], Y_[std::size_t(right[std::size_t(j)])]);
  return result;
}

Vector MovedSet::products(const std::vector<int>& columns, const Vector& y) const
{
  Vector result;
  for (const int column : columns)
    result.push_back(dot(Y_[std::size_t(column)], y));
  return result;
}

Vector MovedSet::corrected(Vector y, const Vector& b, Vector& x) const
{
  Vector onRemoved = products(removed_, y), onAdded = products(added_, y); // -c_R; b_D - c_D
  const Vector across = multiplyTransposed(G_, DenseMatrix(N_->solve(onRemoved))).column(0);
  for (std::size_t j = 0; j < onAdded.size(); ++j)
    onAdded[j] = b[std::size_t(rows_[std::size_t(added_[j])])] - onAdded[j] + across[j];
  onAdded = W_->solve(std::move(onAdded));
  const Vector back = multiply(G_, onAdded);
  for (std::size_t i = 0; i < onRemoved.size(); ++i)
    onRemoved[i] -= back[i];
  onRemoved = N_->solve(std::move(onRemoved));
  for (std::size_t i = 0; i < onRemoved.size(); ++i)
    subtract(y, onRemoved[i], Y_[std::size_t(removed_[i])]);
  for (std::size_t j = 0; j < onAdded.size(); ++j) {
    subtract(y, onAdded[j], Y_[std::size_t(added_[j])]);
    x[std::size_t(rows_[std::size_t(added_[j])])] = onAdded[j];
  }
  return y;
}

} // namespace ndframe
