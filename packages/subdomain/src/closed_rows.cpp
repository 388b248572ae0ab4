#include "ndframe/subdomain/closed_rows.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// Of a row's largest coefficient: below this all that others leave of a row is round-off, and it follows from them.
constexpr double follows = 1e-10;
/// The same of a single coefficient, which rows that decay have in earnest.
constexpr double nothing = 1e-15;

/// A row to which much is added: knows the places of its entries. New ones are appended.
class GrowingRow
{
public:
  /// places: -1 for every column; is so again when this ends.
  GrowingRow(SparseRow& row, std::vector<int>& places) : row_(row), places_(places)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
      places[std::size_t(row[i].first)] = int(i);
  }
  GrowingRow(const GrowingRow&) = delete;
  GrowingRow& operator=(const GrowingRow&) = delete;
  ~GrowingRow()
  {
    for (const auto& entry : row_)
      places_[std::size_t(entry.first)] = -1;
  }

  void add(int column, double value)
  {
    int& place = places_[std::size_t(column)];
    if (place < 0) {
      place = int(row_.size());
      row_.emplace_back(column, value);
    } else {
      row_[std::size_t(place)].second += value;
    }
  }
  void add(const SparseRow& other, double factor)
  {
    for (const auto& [column, value] : other)
      add(column, factor * value);
  }

private:
  SparseRow& row_;
  std::vector<int>& places_;
};

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
      freeNumber_(std::size_t(numVariables), -1), numRows_(rows.size()), columnPlaces_(std::size_t(numVariables), -1),
      rowPlaces_(rows.size(), -1)
{
  for (const int row : chosen)
    add(row, rows[std::size_t(row)], values[std::size_t(row)]);
  for (std::size_t v = 0; v < rowOf_.size(); ++v)
    if (rowOf_[v] < 0)
      freeNumber_[v] = numFree_++;
}

/// row += factor * known, the pivot of `known` taken out already.
void ClosedRows::use(const Reduced& known, double factor, Reduced& row)
{
  GrowingRow(row.others, columnPlaces_).add(known.others, factor);
  GrowingRow(row.combination, rowPlaces_).add(known.combination, factor);
  row.value += factor * known.value;
}

/// Adds a row with what is known of its variables in it.
void ClosedRows::addWithKnown(const SparseRow& entries, Reduced& next)
{
  GrowingRow others(next.others, columnPlaces_), combination(next.combination, rowPlaces_);
  for (const auto& [column, coefficient] : entries) {
    const int number = rowOf_[std::size_t(column)];
    if (number < 0) {
      others.add(column, coefficient);
      continue;
    }
    const Reduced& known = rows_[std::size_t(number)];
    others.add(known.others, -coefficient);
    combination.add(known.combination, -coefficient);
    next.value -= coefficient * known.value;
  }
}

void ClosedRows::add(int row, const SparseRow& entries, double value)
{
  Reduced next{-1, {}, {{row, 1.0}}, value};
  addWithKnown(entries, next);
  const double size = largestCoefficient(entries);
  drop(next.others, nothing * size);
  if (largestCoefficient(next.others) <= follows * size)
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
    const std::size_t before = other.others.size();
    use(next, -coefficient, other);
    for (std::size_t i = before; i < other.others.size(); ++i)
      readers_[std::size_t(other.others[i].first)].push_back(reader);
    for (SparseRow* part : {&other.others, &other.combination})
      drop(*part, nothing * largestCoefficient(*part));
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
