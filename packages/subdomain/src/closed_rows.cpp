#include "ndframe/subdomain/closed_rows.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// Coefficients below this part of a row's largest are round-off.
constexpr double nothing = 1e-10;

void addTo(SparseRow& row, int column, double value)
{
  const auto found =
      std::find_if(row.begin(), row.end(), [column](const auto& entry) { return entry.first == column; });
  if (found == row.end())
    row.emplace_back(column, value);
  else
    found->second += value;
}

/// Takes an entry out of a row; 0 when it is not there.
double taken(SparseRow& row, int column)
{
  const auto found =
      std::find_if(row.begin(), row.end(), [column](const auto& entry) { return entry.first == column; });
  if (found == row.end())
    return 0.0;
  const double value = found->second;
  row.erase(found);
  return value;
}

double largestCoefficient(const SparseRow& row)
{
  double largest = 0.0;
  for (const auto& entry : row)
    largest = std::max(largest, std::abs(entry.second));
  return largest;
}

void drop(SparseRow& row, double below)
{
  row.erase(std::remove_if(row.begin(), row.end(), [below](const auto& e) { return std::abs(e.second) <= below; }),
            row.end());
}

} // namespace

ClosedRows::ClosedRows(const std::vector<SparseRow>& rows, const std::vector<int>& chosen, const Vector& values,
                       int numVariables)
    : rowOf_(std::size_t(numVariables), -1), readers_(std::size_t(numVariables)),
      freeNumber_(std::size_t(numVariables), -1), numRows_(rows.size())
{
  for (const int row : chosen)
    add(row, rows[std::size_t(row)], values[std::size_t(row)]);
  for (std::size_t v = 0; v < rowOf_.size(); ++v)
    if (rowOf_[v] < 0)
      freeNumber_[v] = numFree_++;
}

/// row += factor * known, the pivot of `known` taken out already.
void ClosedRows::use(const Reduced& known, double factor, Reduced& row) const
{
  for (const auto& [column, value] : known.others)
    addTo(row.others, column, factor * value);
  for (const auto& [given, value] : known.combination)
    addTo(row.combination, given, factor * value);
  row.value += factor * known.value;
}

void ClosedRows::add(int row, const SparseRow& entries, double value)
{
  Reduced next{-1, {}, {{row, 1.0}}, value};
  const double size = largestCoefficient(entries);
  for (const auto& [column, coefficient] : entries)
    if (const int known = rowOf_[std::size_t(column)]; known >= 0)
      use(rows_[std::size_t(known)], -coefficient, next);
    else
      addTo(next.others, column, coefficient);
  drop(next.others, nothing * size);
  if (next.others.empty())
    return;
  const auto pivot = std::max_element(next.others.begin(), next.others.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second) < std::abs(b.second);
  });
  const double scale = pivot->second;
  next.pivot = pivot->first;
  next.others.erase(pivot);
  for (auto* part : {&next.others, &next.combination})
    for (auto& entry : *part)
      entry.second /= scale;
  next.value /= scale;
  const int number = int(rows_.size());
  for (const int reader : readers_[std::size_t(next.pivot)]) {
    Reduced& other = rows_[std::size_t(reader)];
    const double coefficient = taken(other.others, next.pivot);
    if (coefficient == 0.0)
      continue;
    use(next, -coefficient, other);
    for (const auto& entry : next.others)
      readers_[std::size_t(entry.first)].push_back(reader);
  }
  for (const auto& entry : next.others)
    readers_[std::size_t(entry.first)].push_back(number);
  rowOf_[std::size_t(next.pivot)] = number;
  independent_.push_back(row);
  rows_.push_back(std::move(next));
}

Vector ClosedRows::direction(const Vector& free) const
{
  Vector v(rowOf_.size(), 0.0);
  for (std::size_t k = 0; k < v.size(); ++k)
    if (freeNumber_[k] >= 0)
      v[k] = free[std::size_t(freeNumber_[k])];
  for (const Reduced& row : rows_)
    for (const auto& [column, value] : row.others)
      v[std::size_t(row.pivot)] -= value * v[std::size_t(column)];
  return v;
}

Vector ClosedRows::expanded(const Vector& free) const
{
  Vector v = direction(free);
  for (const Reduced& row : rows_)
    v[std::size_t(row.pivot)] += row.value;
  return v;
}

Vector ClosedRows::reduced(const Vector& q) const
{
  Vector result(std::size_t(numFree_), 0.0);
  for (std::size_t k = 0; k < q.size(); ++k)
    if (freeNumber_[k] >= 0)
      result[std::size_t(freeNumber_[k])] += q[k];
  for (const Reduced& row : rows_)
    for (const auto& [column, value] : row.others)
      result[std::size_t(freeNumber_[std::size_t(column)])] -= value * q[std::size_t(row.pivot)];
  return result;
}

SparseRow ClosedRows::inFree(int variable) const
{
  const int row = rowOf_[std::size_t(variable)];
  if (row < 0)
    return {{freeNumber_[std::size_t(variable)], 1.0}};
  SparseRow result;
  for (const auto& [column, value] : rows_[std::size_t(row)].others)
    result.emplace_back(freeNumber_[std::size_t(column)], -value);
  return result;
}

Vector ClosedRows::forces(const Vector& q) const
{
  Vector r(numRows_, 0.0);
  for (const Reduced& row : rows_)
    for (const auto& [given, value] : row.combination)
      r[std::size_t(given)] += value * q[std::size_t(row.pivot)];
  return r;
}

} // namespace ndframe
