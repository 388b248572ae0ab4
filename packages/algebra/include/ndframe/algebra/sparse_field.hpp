#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "ndframe/algebra/field.hpp"

namespace ndframe
{

/// Constant values at the nodes of a body of which only those nodes are stored that have any but zero: the forces of a
/// load on a side take no memory inside. Where all nodes have some, it takes as much as a NodalField. Copies share what
/// is stored.
class SparseField
{
public:
  SparseField() = default; ///< of nothing
  /// all: at all nodes.
  explicit SparseField(const NodalField& all) : width_(all.width()), size_(all.map().globalSize())
  {
    const Vector& values = all.whole();
    std::vector<IndexMap::Global> nodes;
    Vector stored;
    for (std::size_t node = 0; node < std::size_t(size_); ++node) {
      const auto first = values.begin() + std::ptrdiff_t(node) * width_;
      if (std::all_of(first, first + width_, [](double value) { return value == 0.0; }))
        continue;
      nodes.push_back(IndexMap::Global(node));
      stored.insert(stored.end(), first, first + width_);
    }
    stored.shrink_to_fit();
    field_ = std::make_shared<const NodalField>(IndexMap(size_, std::move(nodes)), width_, std::move(stored));
  }

  /// Those of nodes of this rank: the map has no others, and of the other ranks' none. largest: of other ranks' values.
  static SparseField ofOwn(NodalField own, double largest = 0.0)
  {
    SparseField result;
    result.width_ = own.width();
    result.largest_ = largest;
    result.size_ = own.map().globalSize();
    result.field_ = std::make_shared<const NodalField>(std::move(own));
    return result;
  }

  std::size_t size() const { return std::size_t(size_) * std::size_t(width_); } ///< values of all nodes
  bool isZero() const { return !field_ || field_->empty(); }                    ///< nothing is stored
  int width() const { return width_; }                                          ///< values of a node
  /// take(node, its values) for every node that is stored, ascending.
  template <class Take>
  void each(const Take& take) const
  {
    for (int i = 0; field_ && i < field_->map().size(); ++i)
      take(field_->map().global(i), field_->at(i));
  }
  /// At all nodes.
  NodalField all() const
  {
    Vector result(size(), 0.0);
    addTo(result);
    return {IndexMap::whole(size_), width_, std::move(result)};
  }
  /// x += factor times the values.
  void addTo(Vector& x, double factor = 1.0) const
  {
    each([&](IndexMap::Global node, const double* values) {
      for (int k = 0; k < width_; ++k)
        x[std::size_t(node) * std::size_t(width_) + std::size_t(k)] += factor * values[k];
    });
  }
  /// The largest modulus, of all ranks.
  double largest() const
  {
    double result = largest_;
    for (std::size_t i = 0; field_ && i < field_->size(); ++i)
      result = std::max(result, std::abs((*field_)[i]));
    return result;
  }

private:
  int width_ = 0;
  IndexMap::Global size_ = 0;
  double largest_ = 0.0;                    ///< of values that other ranks have
  std::shared_ptr<const NodalField> field_; ///< null: of nothing
};

} // namespace ndframe
