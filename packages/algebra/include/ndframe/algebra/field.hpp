#pragma once

#include <utility>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/index_map.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

/// Numbers at what this rank holds of a map, `width` side by side for each. `Where` says what the map counts, so that
/// values of nodes are not taken for values of cells.
///
/// Whether the values are shared out or replicated is a property of the map. What takes them as a plain Vector works on
/// all of them: the conversion asserts that the map is whole.
template <class Where>
class Field
{
public:
  Field() = default; ///< of nothing
  /// Zeros.
  Field(IndexMap map, int width) : Field(std::move(map), width, {})
  {
    values_.resize(std::size_t(map_.size()) * std::size_t(width_), 0.0);
  }
  /// values: `width` for each number that the rank holds, in the order of its own numbers.
  Field(IndexMap map, int width, Vector values) : map_(std::move(map)), width_(width), values_(std::move(values))
  {
    NDFRAME_ASSERT(values_.empty() || values_.size() == std::size_t(map_.size()) * std::size_t(width_),
                   "the values do not fit the map");
  }

  const IndexMap& map() const { return map_; } ///< of what the values belong to
  int width() const { return width_; }         ///< values side by side
  /// The values at a number of this rank.
  const double* at(int i) const { return values_.data() + std::size_t(i) * std::size_t(width_); }
  double* at(int i) { return values_.data() + std::size_t(i) * std::size_t(width_); } ///< the same, to be written

  /// All values, if the rank holds all. Asserts it.
  const Vector& whole() const
  {
    NDFRAME_ASSERT(map_.isWhole(), "values that are shared out were taken for all of them");
    return values_;
  }
  operator const Vector&() const& { return whole(); } ///< the same
  operator Vector() &&                                ///< the same, of a field that ends
  {
    whole();
    return std::move(values_);
  }

  std::size_t size() const { return values_.size(); }           ///< values of this rank
  bool empty() const { return values_.empty(); }                ///< of nothing
  double operator[](std::size_t i) const { return values_[i]; } ///< of this rank's values, one after the other
  double& operator[](std::size_t i) { return values_[i]; }      ///< the same, to be written
  const double* data() const { return values_.data(); }         ///< the same
  double* data() { return values_.data(); }                     ///< the same, to be written
  auto begin() const { return values_.begin(); }                ///< of them
  auto end() const { return values_.end(); }                    ///< of them
  auto begin() { return values_.begin(); }                      ///< of them, to be written
  auto end() { return values_.end(); }                          ///< of them, to be written
  double front() const { return values_.front(); }              ///< of them
  double back() const { return values_.back(); }                ///< of them
  /// The same values, to the bit.
  friend bool operator==(const Field& a, const Field& b) { return a.values_ == b.values_; }
  friend bool operator==(const Field& a, const Vector& b) { return a.whole() == b; }
  friend bool operator==(const Vector& a, const Field& b) { return a == b.whole(); }

private:
  IndexMap map_;
  int width_ = 0;
  Vector values_;
};

/// Values at the nodes of a body: a displacement or forces, `dim` of them at each.
using NodalField = Field<struct AtNodes>;
/// Values of the cells of a body, one for each.
using CellValues = Field<struct OfCells>;
/// Values at the nodes of all interfaces, one for each: a traction or forces along n_c.
using InterfaceValues = Field<struct AtInterfaceNodes>;
/// Values of the unknowns of contact, one for each: displacements, gaps or forces along n_c.
using UnknownValues = Field<struct OfUnknowns>;

/// `dim` values at each of all nodes.
inline NodalField atNodes(Vector values, int dim)
{
  const auto size = IndexMap::Global(values.size());
  return {IndexMap::whole(size / dim), dim, std::move(values)};
}
/// One value for each of all numbers.
template <class Where>
Field<Where> ofAll(Vector values)
{
  const auto size = IndexMap::Global(values.size());
  return {IndexMap::whole(size), 1, std::move(values)};
}
/// The same, of all cells.
inline CellValues ofCells(Vector values)
{
  return ofAll<OfCells>(std::move(values));
}
/// The same, of all interface nodes.
inline InterfaceValues atInterface(Vector values)
{
  return ofAll<AtInterfaceNodes>(std::move(values));
}
/// The same, of all unknowns.
inline UnknownValues ofUnknowns(Vector values)
{
  return ofAll<OfUnknowns>(std::move(values));
}

} // namespace ndframe
