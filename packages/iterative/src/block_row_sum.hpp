#pragma once

#include <algorithm>

#include "ndframe/algebra/block_matrix.hpp"

namespace ndframe
{

/// One row of a block matrix after the other, those of all own nodes, each summed up in any order of its blocks.
class BlockRowSum
{
public:
  /// nodes: own ones and all that may be columns.
  BlockRowSum(int dim, IndexMap nodes)
      : dim_(dim), size_(std::size_t(dim) * std::size_t(dim)), nodes_(std::move(nodes)),
        place_(std::size_t(nodes_.size()), -1)
  {}

  /// A block of the row that is being summed, zero when it is new; node: as this rank numbers them. Valid until the
  /// next call.
  double* block(int node)
  {
    int& place = place_[std::size_t(node)];
    if (place < 0) {
      place = int(columns_.size());
      columns_.push_back(node);
      sums_.resize(sums_.size() + size_, 0.0);
    }
    return sums_.data() + std::size_t(place) * size_;
  }

  /// The next row begins.
  void end()
  {
    std::sort(columns_.begin(), columns_.end());
    for (const int column : columns_) {
      const double* sum = block(column);
      cols_.push_back(column);
      values_.insert(values_.end(), sum, sum + size_);
    }
    rowPtr_.push_back(std::int64_t(cols_.size()));
    for (const int column : columns_)
      place_[std::size_t(column)] = -1;
    columns_.clear();
    sums_.clear();
  }

  BlockMatrix take() &&
  {
    return withoutIdleGhosts(dim_, nodes_, std::move(rowPtr_), std::move(cols_), std::move(values_));
  }

private:
  int dim_;
  std::size_t size_;
  IndexMap nodes_;
  std::vector<int> cols_;
  std::vector<std::int64_t> rowPtr_ = {0};
  std::vector<double> values_;
  std::vector<int> place_; ///< per held node, in the row that is being summed; -1: not there
  std::vector<int> columns_;
  std::vector<double> sums_;
};

} // namespace ndframe
